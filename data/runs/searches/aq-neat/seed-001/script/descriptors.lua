-- SPDX-License-Identifier: MIT
-- Descriptors besides the paper's: the numbers by which two animats are compared. Each number is scaled so that a
-- difference of 1 matters, which is one niche of map-elites and twice the novelty that first enters an archive.
local descriptors = {}

local cells_per_niche = 16
local directions = 16

-- Size and direction: the cells, and the direction of the path, in sixteenths of a turn from 0 (to the right), upwards
-- first. The last sixteenth and the first are neighbours on the circle, but not in the map.
function descriptors.size_and_direction(life)
  local dx = life.finish.x - life.rest.x
  local dy = life.finish.y - life.rest.y
  local turn = math.atan2(dy, dx) / (2 * math.pi)
  if turn < 0 then turn = turn + 1 end
  if turn >= 1 then turn = 0 end -- a hair below 0, rounded up
  return { life.cells / cells_per_niche, turn * directions }
end

local longest = 8 -- times as long as wide; a body without width counts as this

-- Shape alone, known before the body moves: its size, how slender it is, and how densely its cells are linked (from 1 in
-- a chain to nearly 3 in a disc).
function descriptors.shape(life)
  local elongation = life.elongation > 0 and math.min(life.elongation, longest) or longest
  return { life.cells / cells_per_niche, elongation, 4 * life.springs / math.max(life.cells, 1) }
end

return descriptors
