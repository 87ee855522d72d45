-- SPDX-License-Identifier: MIT
-- refused: too much memory in one call
local s = ("x"):rep(1000000)
for i = 1, 1e9 do local t = s .. i end
