-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local n = 0
return paper.experiment {
  name = "guest",
  search = "nsga2",
  objectives = { "fitness", { name = "cost", goal = "minimise", value = function(life, parameters) n = n + 1 return n end } },
}
