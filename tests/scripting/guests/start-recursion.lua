-- SPDX-License-Identifier: MIT
-- refused: stack overflow
local paper = require "paper"
return paper.experiment {
  name = "guest",
  start = { generations = 2, behaviour = function(life, parameters) local function f() return 1 + f() end return f() end },
}
