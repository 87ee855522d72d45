-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local each, list, place = pairs { 1, 2, 3 }
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) return each(list, place) end,
}
