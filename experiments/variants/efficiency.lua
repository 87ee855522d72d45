-- SPDX-License-Identifier: MIT
-- Which walkers go far at low cost? The fitness of gene networks on land is divided by how much their muscles switch;
-- bodies below a dozen cells do not count. Fitness and penalty are functions of a finished life, here made from the
-- paper's own.
local paper = require "paper"

local smallest = 12 -- cells

local function penalty(life, parameters)
  if life.cells < smallest then return 0 end
  return paper.judgement.penalty(life, parameters)
end

local function fitness(life, parameters, p)
  return life.displacement / (1 + life.activity) * p
end

return paper.experiment {
  name = "efficiency",
  title = "Distance per effort",
  actuation = "grn",
  environment = paper.terrestrial(),
  penalty = penalty,
  fitness = fitness,
}
