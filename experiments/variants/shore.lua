-- SPDX-License-Identifier: MIT
-- Can bodies walk into the water and swim on? The ground falls from land into a lake, whose water drags on what is
-- below its surface and carries nearly all of the weight. Only the way to the right counts.
local paper = require "paper"

local function rightwards(life, parameters, penalty)
  return math.max(life.finish.x - life.rest.x, 0) * penalty
end

return paper.experiment {
  name = "shore",
  title = "From land into water",
  environment = paper.terrestrial {
    ground = { { -20, 0 }, { 4, 0 }, { 24, -10 } },
    regions = {
      { top = -1, drag = { normal = "drag_normal", tangential = "drag_tangential" }, buoyancy = 0.95 },
    },
  },
  fitness = rightwards,
}
