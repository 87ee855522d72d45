-- SPDX-License-Identifier: MIT
-- The paper's two searches beside three others, with oscillators in both worlds and at equal numbers of evaluations. Each
-- search is judged by the same fitness. Searches use descriptors for different purposes, so map-elites and local competition
-- have one that suits them.
local paper = require "paper"
local descriptors = require "descriptors"

local searches = {
  { name = "neat", title = "fitness", search = "neat" },
  { name = "novelty", title = "novelty", search = "novelty" },
  { name = "nsga2", title = "fitness and novelty", search = "nsga2" },
  { name = "nslc", title = "local competition", search = "nslc", behaviour = descriptors.shape },
  { name = "map-elites", title = "elites", search = "map-elites", behaviour = descriptors.size_and_direction },
  { name = "bodies-first", title = "novelty from diverse bodies", search = "novelty",
    start = { generations = 30, behaviour = descriptors.shape } },
}
local worlds = {
  { name = "aq", title = "in water", environment = paper.aquatic() },
  { name = "te", title = "on land", environment = paper.terrestrial() },
}

local settings = {}
for _, world in ipairs(worlds) do
  for _, search in ipairs(searches) do
    settings[#settings + 1] = planula.change(search, {
      name = world.name .. "-" .. search.name,
      title = "Oscillators " .. world.title .. ": " .. search.title,
      environment = world.environment,
    })
  end
end

return paper.design {
  name = "searches",
  title = "Searches at equal evaluations",
  parameters = { seeds = 3, population = 100, generations = 40 },
  record = "sample",
  settings = settings,
}
