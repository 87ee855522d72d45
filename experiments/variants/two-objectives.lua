-- SPDX-License-Identifier: MIT
-- How much work does each distance take? NSGA-II keeps the swimmers that no other beats in both; individuals.csv.gz has
-- both numbers of all of them. Bodies that never move are on the front too, as they work least.
local paper = require "paper"

local function distance(life) return life.displacement end
local function work(life) return life.work end

return paper.experiment {
  name = "two-objectives",
  title = "Distance against work",
  search = "nsga2",
  objectives = {
    { name = "distance", value = distance, goal = "maximise" },
    { name = "work", value = work, goal = "minimise" },
  },
}
