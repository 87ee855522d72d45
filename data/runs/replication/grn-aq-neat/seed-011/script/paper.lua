-- SPDX-License-Identifier: MIT
-- The paper as a starting point: Joachimczak, Suzuki & Arita (2015), Front. Robot. AI 2:33. A script names what
-- differs, everything else is the paper's. See experiments/variants/ for examples.
local environments = require "paper.environments"
local judgement = require "paper.judgement"

local paper = { environments = environments, judgement = judgement }

-- The paper's water or land, with some of its values changed:
-- paper.aquatic { drag = { normal = 8, tangential = 4 } }.
function paper.aquatic(changes)
  return planula.change(environments.aquatic, changes or {})
end

function paper.terrestrial(changes)
  return planula.change(environments.terrestrial, changes or {})
end

-- Oscillators in water, evolved by NEAT, judged as in the paper.
local standard = {
  actuation = "oscillator",
  search = "neat",
  environment = paper.aquatic(),
  fitness = judgement.fitness,
  penalty = judgement.penalty,
  behaviour = judgement.behaviour,
}

-- An experiment with one setting: the statement, completed by the standard.
function paper.experiment(statement)
  return planula.fill(statement, planula.fill({ statistics = "paper.summary" }, standard))
end

-- An experiment with several settings, each completed by the standard.
function paper.design(statement)
  local design = planula.fill(statement, { statistics = "paper.summary" })
  if type(design.settings) ~= "table" then error("paper.design needs settings = { … }", 2) end
  local settings = {}
  for index, setting in ipairs(design.settings) do
    settings[index] = type(setting) == "table" and planula.fill(setting, standard) or setting
  end
  design.settings = settings
  return planula.locate(design)
end

return paper
