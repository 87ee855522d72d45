-- SPDX-License-Identifier: MIT
-- Who comes far for little work? Distance over the square root of the cost of transport, which is the positive work of
-- all muscles per cell and per distance. Unlike `activity` it means the same for oscillators and gene networks.
local paper = require "paper"

local free = 10 -- work per cell and distance that costs nothing, so that a body which only drifts scores no infinity

local function fitness(life, parameters, penalty)
  local distance = life.displacement
  if distance == 0 then return 0 end
  local cost = life.work / (life.cells * distance)
  return distance / math.sqrt(free + cost) * penalty
end

return paper.experiment {
  name = "cost-of-transport",
  title = "Distance at low cost of transport",
  fitness = fitness,
}
