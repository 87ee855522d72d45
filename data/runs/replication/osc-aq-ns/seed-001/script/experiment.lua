-- SPDX-License-Identifier: MIT
-- The paper's experiment (§3): two worlds, two actuations, two searches; 20 seeds of 2000 generations of 300
-- individuals each, which are the standard values of the parameters.
local paper = require "paper"

return paper.design {
  name = "replication",
  title = "Joachimczak, Suzuki & Arita (2015)",
  statistics = "paper.statistics",
  record = 300, -- a sample of the individuals: what figures and claims need; "full" keeps every one, 45 MB a run
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
