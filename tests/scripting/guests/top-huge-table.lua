-- SPDX-License-Identifier: MIT
-- refused: too much memory
local t = {}
for i = 1, 1e9 do t[i] = { i } end
