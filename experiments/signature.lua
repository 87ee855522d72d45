-- SPDX-License-Identifier: MIT
-- What `planula signature` signs: every rule of the model, in runs so small that all of them take seconds. The hash
-- over these runs is the revision of the model, so whatever changes here changes that, too.
--
-- The paper's settings come first, with their own parameters. In the others rules act within a few generations
-- that would otherwise act late or seldom: evaluations are brief, and parameters have values at which a change of any
-- of them shows, which tests/torture/parameters.sh checks. Nothing here is meant to evolve well.
local paper = require "paper"
local descriptors = require "descriptors"
local replication = require "paper.replication"

local settings = {}
for index, setting in ipairs(replication.settings) do settings[index] = setting end
local function add(setting) settings[#settings + 1] = setting end

-- Movement of a few hundred steps, after a short rest.
local function brief(parameters)
  return planula.fill(parameters, {
    locomotion_steps = 400, ramp_steps = 100, settle_window = 100, settle_limit = 1000,
  })
end

-- Networks that change their structure often, by operators that fail now and then.
local restless = {
  add_node_rate = 0.3, add_link_rate = 0.4, remove_link_rate = 0.2, mutate_weights_rate = 0.3, mutation_rate = 0.9,
  propagation_limit = 2, recurrent_rate = 0.6, loop_rate = 0.4, weight_limit = 2,
  link_tries = 3, split_tries = 2, operator_tries = 2, mate_tries = 1, clone_tries = 3, clone_distance = 0.3,
}

-- Species that are few and many, young, old, stagnating and mixed, all within ten generations.
local species = brief(planula.fill({
  population = 24, generations = 12,
  compatibility_threshold = 3.5, compatibility_floor = 2.8, compatibility_step = 0.4, species_low = 3, species_high = 5,
  young_age = 2, old_age = 3, old_penalty = 0.5, stagnation_limit = 1, stagnation_penalty = 0.1, fitness_floor = 0.002,
  interspecies_rate = 0.4,
}, restless))

-- An archive whose threshold rises from the second addition in a row on, and falls after two quiet generations.
local archive = brief {
  population = 20, generations = 8, novelty_neighbours = 4,
  archive_threshold = 0.1, archive_floor = 0.04, archive_run = 1, archive_raise = 1.5, archive_patience = 2, archive_lower = 0.6,
}

add { name = "species", search = "neat", parameters = species }
add { name = "recurrence", search = "neat", actuation = "grn",
      parameters = planula.fill({
        add_node_rate = 0.5, add_link_rate = 0.8, recurrent_rate = 0.8,
        compatibility_threshold = 5, compatibility_floor = 4.5,
      }, species) }
add { name = "archive", search = "novelty", parameters = archive }
-- A threshold that no individual reaches falls to its lowest value.
add { name = "quiet-archive", search = "novelty",
      parameters = brief { population = 4, generations = 8, archive_threshold = 100, archive_floor = 75, archive_patience = 2,
                           archive_lower = 0.9 } }
add { name = "nsga2", search = "nsga2", actuation = "grn", parameters = archive }
add { name = "nslc", search = "nslc", environment = paper.terrestrial(), behaviour = descriptors.shape, parameters = archive }
add { name = "map-elites", search = "map-elites", behaviour = descriptors.size_and_direction,
      parameters = brief(restless) }
add { name = "bodies-first", search = "novelty", start = { generations = 4, behaviour = descriptors.shape },
      parameters = brief { generations = 2 } }

-- Rules that choices of the model name beside the standard ones (paper/decisions/0020-readings.md). Recorded results of
-- tests/core/development/ and tests/core/analysis/ cover `both` and `plane`.
add { name = "turns", search = "novelty", actuation = "grn",
      parameters = brief { division_turn = "daughter", division_angle_range = 0.5, gait_time = "rising", start_weight = 2 } }
add { name = "aged-novelty", search = "novelty", parameters = planula.fill({ novelty_species = "aged" }, species) }
add { name = "tissue-frame", search = "neat", actuation = "grn", environment = paper.terrestrial(),
      parameters = brief { division_turn = "nobody", orientation_frame = "tissue", gait_place = "present" } }

-- A valley, and a river that also flows upwards.
add { name = "slopes", search = "neat", actuation = "grn", parameters = brief {},
      environment = paper.terrestrial { ground = { { -8, 4 }, { -1, 0 }, { 1, 0.2 }, { 5, 3 } } } }
add { name = "current", search = "neat", parameters = brief {},
      environment = paper.aquatic { flow = { x = 0.2, y = 0.05 } } }

-- Bodies that reach the limits of growth, and move beyond those of the simulation.
add { name = "limits", search = "neat", environment = paper.terrestrial(),
      parameters = brief { cell_limit = 40, birth_limit = 30, minimum_cells = 4, cell_speed_limit = 0.02, area_floor = 0.5,
                           node_speed_limit = 0.04, contact_radius = 0.8, link_limit = 1.1 } }

return paper.design {
  name = "signature",
  title = "What the signature signs",
  parameters = { seeds = 1, population = 16, generations = 4 },
  settings = settings,
}
