-- SPDX-License-Identifier: MIT
-- Distance for its price: gene networks on land whose fitness is divided by how much their muscles switch, and
-- bodies below a dozen cells are not counted. Fitness and penalty are functions of a finished life; the paper's
-- own are there to build on.
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
