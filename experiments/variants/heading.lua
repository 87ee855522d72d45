-- SPDX-License-Identifier: MIT
-- Does novelty search find other animats if it looks at the whole path, not only at its end? Behaviour is a list of
-- numbers of any fixed length; distances between lists are Euclidean.
local paper = require "paper"

-- Where the body was after half of its path, and at the end.
local function behaviour(life)
  local middle = life.path[math.ceil(#life.path / 2)]
  return { middle.x, middle.y, life.finish.x, life.finish.y }
end

return paper.experiment {
  name = "heading",
  title = "Novelty of the path",
  search = "novelty",
  behaviour = behaviour,
}
