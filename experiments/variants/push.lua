-- SPDX-License-Identifier: MIT
-- Who pushes? A loose object, as soft as the body and without muscles, lies on the ground to the right. The
-- fitness is how far the body pushes it, in either direction.
local paper = require "paper"

local function pushed(life, parameters, penalty)
  return math.abs(life.object_finish.x - life.object_rest.x) * penalty
end

return paper.experiment {
  name = "push",
  title = "Push an object",
  environment = paper.terrestrial { object = { at = { 6, 2 }, radius = 1 } },
  fitness = pushed,
}
