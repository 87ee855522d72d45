-- SPDX-License-Identifier: MIT
-- Steps to climb on one side and ice on the other: a patch of nearly no friction, behind which the ground holds again.
-- Which way do bodies take?
local paper = require "paper"

local steps = {}
for i = 1, 5 do
  local left = 2 + 3 * i
  steps[i] = { points = { { left, -1 }, { left + 40, -1 }, { left + 40, i / 2 }, { left, i / 2 } }, friction = 1 }
end

return paper.experiment {
  name = "steps-and-ice",
  title = "Steps and ice",
  environment = paper.terrestrial {
    obstacles = steps,
    friction_patches = { { from = -12, to = -3, friction = 0.02 } },
  },
}
