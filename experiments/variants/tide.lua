-- SPDX-License-Identifier: MIT
-- Who swims in a current that changes with time? The tide goes to and fro once in 1000 steps. A drifting body comes
-- back to where it was, so the paper's distance counts what a body swims.
local paper = require "paper"

local function tide(t)
  return 0.3 * math.sin(2 * math.pi * t / 1000)
end

return paper.experiment {
  name = "tide",
  title = "A tide",
  environment = paper.aquatic { flow = { x = tide, step = 20, period = 1000 } },
}
