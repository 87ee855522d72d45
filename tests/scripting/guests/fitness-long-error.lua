-- SPDX-License-Identifier: MIT
-- refused: xxx
local paper = require "paper"
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) error(("x"):rep(3e6)) end,
}
