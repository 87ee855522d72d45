-- SPDX-License-Identifier: MIT
-- refused: cannot be changed
local paper = require "paper"
return paper.experiment {
  name = "guest",
  behaviour = function(life, parameters) parameters.cell_limit = 3 return 1 end,
}
