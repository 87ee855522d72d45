-- SPDX-License-Identifier: MIT
-- A current that changes with time: a tide that goes to and fro once in 1000 steps. A drifting body comes back to where
-- it was, so the paper's distance counts what a body swims.
local paper = require "paper"

local function tide(t)
  return 0.3 * math.sin(2 * math.pi * t / 1000)
end

return paper.experiment {
  name = "tide",
  title = "A tide",
  environment = paper.aquatic { flow = { x = tide, step = 20, period = 1000 } },
}
