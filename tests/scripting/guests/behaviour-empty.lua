-- SPDX-License-Identifier: MIT
-- refused: a list of 1 … 16 numbers
local paper = require "paper"
return paper.experiment {
  name = "guest",
  behaviour = function() return {} end,
}
