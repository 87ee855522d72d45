-- SPDX-License-Identifier: MIT
-- A map of the best swimmers of every size into every direction. Each of its niches spans 1 in every number of the
-- descriptor (parameter niche_width); archive.csv.gz lists all that entered; the last of a niche is its elite.
local paper = require "paper"
local descriptors = require "descriptors"

return paper.experiment {
  name = "map-elites",
  title = "Elites by size and direction",
  search = "map-elites",
  behaviour = descriptors.size_and_direction,
}
