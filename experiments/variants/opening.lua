-- SPDX-License-Identifier: MIT
-- An opening: a wall hangs over the ground and leaves one and a half cells free. How far to the right does a body of
-- thirty cells or more get? It has to be flat, or to crawl through.
local paper = require "paper"

local free = 1.5 -- cells between wall and ground
local wall = { { 8, free }, { 11, free }, { 11, 30 }, { 8, 30 } }

local function penalty(life, parameters)
  return life.cells < 30 and 0 or paper.judgement.penalty(life, parameters)
end

local function to_the_right(life, parameters, p)
  return math.max(life.finish.x - life.rest.x, 0) * p
end

return paper.experiment {
  name = "opening",
  title = "Through an opening",
  environment = paper.terrestrial { obstacles = { wall } },
  penalty = penalty,
  fitness = to_the_right,
}
