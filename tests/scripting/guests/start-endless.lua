-- SPDX-License-Identifier: MIT
-- refused: too many instructions
local paper = require "paper"
return paper.experiment {
  name = "guest",
  start = { generations = 2, behaviour = function(life, parameters) while true do end end },
}
