-- SPDX-License-Identifier: MIT
-- refused: stack overflow
local t = {}
t.t = t
return planula.change(t, t)
