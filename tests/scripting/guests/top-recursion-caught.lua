-- SPDX-License-Identifier: MIT
-- refused: nested more than 150 deep
local function f() local ok, why = pcall(f) if not ok then error(why) end end
f()
