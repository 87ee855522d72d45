-- SPDX-License-Identifier: MIT
-- refused: no
local paper = require "paper"
return paper.experiment {
  name = "guest",
  behaviour = function(life, parameters) error("no") end,
}
