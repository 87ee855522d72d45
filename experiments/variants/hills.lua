-- SPDX-License-Identifier: MIT
-- Ground as a function of x. It is sampled once, before the first evaluation, every `step` from `from` to `to`, and is
-- straight between the samples. The hills grow with the distance from the start.
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
