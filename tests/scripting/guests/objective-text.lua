-- SPDX-License-Identifier: MIT
-- refused: number
local paper = require "paper"
local n = 0
return paper.experiment {
  name = "guest",
  search = "nsga2",
  objectives = { "fitness", { name = "cost", goal = "minimise", value = function(life, parameters) return "1" end } },
}
