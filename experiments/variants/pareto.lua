-- SPDX-License-Identifier: MIT
-- What do fitness and novelty find together? NSGA-II prefers no individual that is both less fit and less novel than
-- another. A search is stated in one line; the behaviour is the paper's.
local paper = require "paper"

return paper.experiment {
  name = "pareto",
  title = "Fitness and novelty by NSGA-II",
  search = "nsga2",
}
