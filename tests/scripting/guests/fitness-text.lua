-- SPDX-License-Identifier: MIT
-- refused: fitness returned string, not a number
local paper = require "paper"
return paper.experiment {
  name = "guest",
  fitness = function() return "1" end,
}
