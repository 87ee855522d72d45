-- SPDX-License-Identifier: MIT
-- Fitness and novelty at once: NSGA-II prefers nobody who is both less fit and less novel than another. A search is
-- one line; the behaviour stays the paper's.
local paper = require "paper"

return paper.experiment {
  name = "pareto",
  title = "Fitness and novelty by NSGA-II",
  search = "nsga2",
}
