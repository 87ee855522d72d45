-- SPDX-License-Identifier: MIT
-- refused: life has no 'fitnes'
local paper = require "paper"
local n = 0
return paper.experiment {
  name = "guest",
  search = "nsga2",
  objectives = { "fitness", { name = "cost", goal = "minimise", value = function(life, parameters) return life.fitnes end } },
}
