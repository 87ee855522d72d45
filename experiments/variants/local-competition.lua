-- SPDX-License-Identifier: MIT
-- Local competition: animats compete with those of similar shape, so that small and large, slender and round ones
-- are all improved. The descriptor defines which are similar.
local paper = require "paper"
local descriptors = require "descriptors"

return paper.experiment {
  name = "local-competition",
  title = "Novelty of shape with local competition",
  search = "nslc",
  environment = paper.terrestrial(),
  behaviour = descriptors.shape,
}
