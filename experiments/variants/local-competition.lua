-- SPDX-License-Identifier: MIT
-- Do small and large, slender and round animats all improve if each competes only with those of similar shape? The
-- descriptor defines which are similar.
local paper = require "paper"
local descriptors = require "descriptors"

return paper.experiment {
  name = "local-competition",
  title = "Novelty of shape with local competition",
  search = "nslc",
  environment = paper.terrestrial(),
  behaviour = descriptors.shape,
}
