-- SPDX-License-Identifier: MIT
-- refused: too many instructions
local a, b, t = ("x"):rep(5e6) .. "a", ("x"):rep(5e6) .. "b", {}
for i = 1, 20000 do t[i] = i % 2 == 0 and a or b end
table.sort(t)
