-- SPDX-License-Identifier: MIT
-- refused: read-only
local paper = require "paper"
return paper.experiment {
  name = "guest",
  start = { generations = 2, behaviour = function(life, parameters) life.cells = 3 return 1 end },
}
