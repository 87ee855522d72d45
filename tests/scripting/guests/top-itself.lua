-- SPDX-License-Identifier: MIT
-- refused: nested more than 16 deep, or contain themselves
local t = { name = "guest" }
t.environment = t
return t
