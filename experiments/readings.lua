-- SPDX-License-Identifier: MIT
-- How the article's rules can be read (paper/decisions/0020-readings.md): evolves the replication's settings under each
-- reading. The first reading is the standard one. Each of the others differs from it in one rule or
-- number, except the second, which was the standard before heredity was measured.
local paper = require "paper"
local replication = require "paper.replication"

local standard = {
  division_turn = "nobody", orientation_frame = "tissue", division_angle_range = 0.5, start_weight = 3, weight_power = 0.2,
}

local readings = {
  { name = "standard",  title = "standard",                                parameters = {} },
  { name = "earlier",   title = "earlier standard",                        parameters = {
    division_turn = "both", orientation_frame = "plane", division_angle_range = 1, start_weight = 1, weight_power = 1 } },
  { name = "both-turn", title = "mother and daughter turn",                parameters = { division_turn = "both" } },
  { name = "daughters", title = "daughters turn",                          parameters = { division_turn = "daughter" } },
  { name = "plane",     title = "orientations fixed in the plane",         parameters = { orientation_frame = "plane" } },
  { name = "range-1",   title = "divisions up to a half turn off",         parameters = { division_angle_range = 1 } },
  { name = "range-025", title = "divisions up to an eighth of a turn off", parameters = { division_angle_range = 0.25 } },
  { name = "clearance", title = "daughters need 0.75 cells",               parameters = { division_clearance = 0.75 } },
  { name = "start-1",   title = "start weights up to 1",                   parameters = { start_weight = 1 } },
  { name = "power-1",   title = "weight mutations up to 1",                parameters = { weight_power = 1 } },
  -- What gene networks read during locomotion, and what novelty search leaves out, concerns some settings only.
  { name = "rising",    title = "time goes on rising",                     parameters = { gait_time = "rising" },     only = "grn" },
  { name = "present",   title = "networks read their present place",       parameters = { gait_place = "present" },   only = "grn" },
  { name = "aged",      title = "novelty search with factors of age",      parameters = { novelty_species = "aged" }, only = "-ns" },
}

local settings = {}
for _, reading in ipairs(readings) do
  for _, setting in ipairs(replication.settings) do
    if not reading.only or setting.name:find(reading.only, 1, true) then
      settings[#settings + 1] = planula.change(setting, {
        name = reading.name .. "-" .. setting.name,
        title = setting.title .. ": " .. reading.title,
        parameters = planula.fill(reading.parameters, standard),
      })
    end
  end
end

return paper.design {
  name = "readings",
  title = "Readings of the article",
  parameters = { seeds = 3, generations = 60 },
  record = "sample",
  settings = settings,
}
