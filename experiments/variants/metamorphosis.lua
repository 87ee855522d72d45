-- SPDX-License-Identifier: MIT
-- Is there one body for two worlds? It swims for half of its life, is set on land, comes to rest there, and walks on. The
-- fitness is the shorter of the two ways, so that only bodies that do both score.
local paper = require "paper"

local function both(life, parameters, penalty)
  local shortest = math.huge
  for i = 1, #life.phase_finish do
    local from, to = life.phase_start[i], life.phase_finish[i]
    local x, y = to.x - from.x, to.y - from.y
    shortest = math.min(shortest, math.sqrt(x * x + y * y))
  end
  return shortest < math.huge and shortest * penalty or 0
end

return paper.experiment {
  name = "metamorphosis",
  title = "Water, then land",
  phases = { { at = 2000, environment = paper.terrestrial(), settle = true } },
  fitness = both,
}
