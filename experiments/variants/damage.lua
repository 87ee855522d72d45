-- SPDX-License-Identifier: MIT
-- Which bodies swim on when they lose a part? After half of its life each body loses the third of its cells that grew
-- farthest to the left, and only the way from there on counts.
local paper = require "paper"

local function after_damage(life, parameters, penalty)
  local from = life.path[math.ceil(#life.path / 2)]
  if not from then return 0 end
  local x, y = life.finish.x - from.x, life.finish.y - from.y
  return math.sqrt(x * x + y * y) * penalty
end

return paper.experiment {
  name = "damage",
  title = "Swimming on with two thirds",
  damage = { at = 2000, share = 1 / 3, side = "left" },
  fitness = after_damage,
}
