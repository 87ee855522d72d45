-- SPDX-License-Identifier: MIT
-- What is the best swimmer of every size into every direction? `descriptor` names the numbers of the behaviour and
-- divides the range of each into niches; archive.csv.gz lists all that entered, and the last of a niche is its elite.
local paper = require "paper"

-- The cells of the body, and the direction of its path, in turns from 0 (to the right), upwards first.
local function behaviour(life)
  local dx, dy = life.finish.x - life.rest.x, life.finish.y - life.rest.y
  return { life.cells, math.atan2(dy, dx) / (2 * math.pi) % 1 }
end

return paper.experiment {
  name = "map-elites",
  title = "Elites by size and direction",
  search = "map-elites",
  behaviour = behaviour,
  descriptor = {
    { name = "cells", from = 0, to = 256, cells = 16 },
    { name = "turn", from = 0, to = 1, cells = 16 },
  },
}
