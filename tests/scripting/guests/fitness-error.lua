-- SPDX-License-Identifier: MIT
-- refused: no
local paper = require "paper"
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) error("no") end,
}
