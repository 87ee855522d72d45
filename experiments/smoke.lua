-- SPDX-License-Identifier: MIT
-- All settings of the paper at a size that takes a minute: does everything work together? Its claims stay
-- open, as too little is run to judge them.
local paper = require "paper"

return paper.design {
  name = "smoke",
  title = "Every setting, for a minute",
  statistics = "paper.statistics",
  parameters = { seeds = 2, population = 24, generations = 4 },
  settings = {
    { name = "osc-aq-neat", title = "Oscillators, water, NEAT",         actuation = "oscillator", search = "neat",    environment = paper.aquatic() },
    { name = "osc-aq-ns",   title = "Oscillators, water, novelty",      actuation = "oscillator", search = "novelty", environment = paper.aquatic() },
    { name = "osc-te-neat", title = "Oscillators, land, NEAT",          actuation = "oscillator", search = "neat",    environment = paper.terrestrial() },
    { name = "osc-te-ns",   title = "Oscillators, land, novelty",       actuation = "oscillator", search = "novelty", environment = paper.terrestrial() },
    { name = "grn-aq-neat", title = "Gene networks, water, NEAT",       actuation = "grn",        search = "neat",    environment = paper.aquatic() },
    { name = "grn-aq-ns",   title = "Gene networks, water, novelty",    actuation = "grn",        search = "novelty", environment = paper.aquatic() },
    { name = "grn-te-neat", title = "Gene networks, land, NEAT",        actuation = "grn",        search = "neat",    environment = paper.terrestrial() },
    { name = "grn-te-ns",   title = "Gene networks, land, novelty",     actuation = "grn",        search = "novelty", environment = paper.terrestrial() },
  },
}
