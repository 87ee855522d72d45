-- SPDX-License-Identifier: MIT
-- Is it better to evolve bodies first? Before the run, generation 0 is evolved for diverse shapes by novelty search on
-- growth alone, which costs little. The paper's discussion proposes it for novelty search, too.
local paper = require "paper"
local descriptors = require "descriptors"

return paper.experiment {
  name = "morphology-first",
  title = "From diverse bodies",
  start = { generations = 30, behaviour = descriptors.shape },
}
