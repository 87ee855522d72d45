-- SPDX-License-Identifier: MIT
-- Can walkers climb hills that grow with the distance from the start? Ground is a function of x, sampled once, before
-- the first evaluation, every `step` from `from` to `to`, and straight between the samples.
local paper = require "paper"

local function height(x)
  return math.min(math.abs(x) / 40, 1.5) * math.sin(x / 4)
end

return paper.experiment {
  name = "hills",
  title = "Rolling hills",
  environment = paper.terrestrial {
    ground = { height = height, from = -200, to = 200, step = 0.5 },
  },
}
