-- SPDX-License-Identifier: MIT
-- refused: these are the first 100 problems
local t = { name = "guest" }
for i = 1, 150000 do t["key" .. i] = i end
return planula.experiment(t)
