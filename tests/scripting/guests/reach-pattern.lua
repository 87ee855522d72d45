-- SPDX-License-Identifier: MIT
-- refused: the experiment
local at = ("a.b"):find(".")
if at ~= 2 then error("a pattern") end
return { nothing = 1 }
