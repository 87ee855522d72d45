-- SPDX-License-Identifier: MIT
-- Who swims against a river that flows to the right? A drifting body would score well without swimming, so the fitness
-- counts only how far it came against the stream; the other functions of the judgement are the paper's.
local paper = require "paper"

local function upstream(life, parameters, penalty)
  return math.max(life.rest.x - life.finish.x, 0) * penalty
end

return paper.experiment {
  name = "current",
  title = "Against the stream",
  environment = paper.aquatic { flow = { x = 0.2, y = 0 } },
  fitness = upstream,
}
