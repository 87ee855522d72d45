-- SPDX-License-Identifier: MIT
-- What the paper claims of its eight settings, each claim with the test that judges it here. Claims with several
-- parts are split: S4a and S4b are both the paper's. `paper` is its own evidence; generations count from 1. The
-- tests are in experiments/paper/tests.lua, their arithmetic is core/statistics.
--
-- A test is two-tailed where the paper's is. A claim of no difference states with `bound` which difference is negligible, and is
-- reproduced only if a test shows that the difference is smaller; decision 0015 has the error rates of all tests.
--
-- What the paper shows only by pictures is tested by a number where a number says the same. There is none for S14 (how the
-- best bodies look), which is left to Figs. 3-5.
local summary = require "paper.summary"
local tests = require "paper.tests"

-- §3.1: a gait is cyclic if its last quarter has at least this share of the path and this share of all changes of the muscle
-- signals; an even gait has 0.25 of both.
local late_share = 0.1

-- S7 is reproduced if its number of runs shows that fewer than this share of all runs would lack a cyclic gait: of 20 runs
-- at most one may.
local without_gait = 0.25

-- No difference: A12 between 0.29 and 0.71, beyond which Vargha & Delaney (2000) call an effect large. Twenty runs against
-- twenty cannot show much less.
local no_large_effect = 0.21

return planula.fill({
  -- Figs. 8-10 show both searches in water and on land.
  endpoints = { "osc-aq-neat", "osc-aq-ns", "osc-te-neat", "osc-te-ns" },

  claims = {
    -- §3.2, oscillators: the best of a generation, 20 runs against 20 (Fig. 6).
    tests.best_at_generation {
      id = "S1", statement = "Swimmers with oscillators: novelty search is better after 2000 generations",
      section = "§3.2", paper = "p = 0.01",
      a = "osc-aq-ns", b = "osc-aq-neat", generation = 2000, expect = "greater",
    },
    tests.best_at_generation {
      id = "S2", statement = "Walkers with oscillators: no significant difference after 2000 generations",
      section = "§3.2", paper = "p = 0.30",
      a = "osc-te-ns", b = "osc-te-neat", generation = 2000, expect = "no_difference",
      bound = no_large_effect,
    },
    tests.best_at_generation {
      id = "S3", statement = "Walkers with oscillators: novelty search is better after 400 generations",
      section = "§3.2", paper = "p = 0.02",
      a = "osc-te-ns", b = "osc-te-neat", generation = 400, expect = "greater",
    },

    -- §3.3, gene networks (Fig. 7).
    tests.best_at_generation {
      id = "S4a", statement = "Swimmers with gene networks: novelty search is better after 800 generations",
      section = "§3.3", paper = "p = 0.008",
      a = "grn-aq-ns", b = "grn-aq-neat", generation = 800, expect = "greater",
    },
    tests.best_at_generation {
      id = "S4b", statement = "Swimmers with gene networks: no significant difference after 2000 generations",
      section = "§3.3", paper = "not significant",
      a = "grn-aq-ns", b = "grn-aq-neat", generation = 2000, expect = "no_difference",
      bound = no_large_effect,
    },
    tests.best_at_generation {
      id = "S5a", statement = "Walkers with gene networks: novelty search is better after 800 generations",
      section = "§3.3", paper = "p = 0.01",
      a = "grn-te-ns", b = "grn-te-neat", generation = 800, expect = "greater",
    },
    tests.best_at_generation {
      id = "S5b", statement = "Walkers with gene networks: no significant difference after 2000 generations",
      section = "§3.3", paper = "p = 0.10",
      a = "grn-te-ns", b = "grn-te-neat", generation = 2000, expect = "no_difference",
      bound = no_large_effect,
    },

    -- §3.2, 3.3: the mean over runs. "Regardless of the number of generations" is read as every generation, "on
    -- average throughout" as most of them. Of two equal searches one is ahead in most generations anyway: the
    -- difference of the means over all generations must be significant as well.
    tests.mean_ahead {
      id = "S6a", statement = "Swimmers with oscillators: the mean of novelty search is ahead in every generation",
      section = "§3.2", paper = "Fig. 6A",
      a = "osc-aq-ns", b = "osc-aq-neat", level = 1,
    },
    tests.mean_ahead {
      id = "S6b", statement = "Walkers with oscillators: the mean of novelty search is ahead in every generation",
      section = "§3.2", paper = "Fig. 6B",
      a = "osc-te-ns", b = "osc-te-neat", level = 1,
    },
    tests.mean_ahead {
      id = "S6c", statement = "Swimmers with gene networks: the mean of novelty search is ahead throughout",
      section = "§3.3", paper = "Fig. 7A",
      a = "grn-aq-ns", b = "grn-aq-neat", level = 0.5,
    },
    tests.mean_ahead {
      id = "S6d", statement = "Walkers with gene networks: the mean of novelty search is ahead throughout",
      section = "§3.3", paper = "Fig. 7B",
      a = "grn-te-ns", b = "grn-te-neat", level = 0.5,
    },

    -- §3.1: all runs end in a cyclic gait, but for one swimmer and one walker of NEAT with gene networks.
    tests.cyclic {
      id = "S7a", statement = "Swimmers with oscillators, NEAT: all gaits are cyclic", calibrated = true,
      section = "§3.1", paper = "0 of 20 are not", a = "osc-aq-neat", level = late_share, count = 0,
      bound = without_gait,
    },
    tests.cyclic {
      id = "S7b", statement = "Swimmers with oscillators, novelty: all gaits are cyclic", calibrated = true,
      section = "§3.1", paper = "0 of 20 are not", a = "osc-aq-ns", level = late_share, count = 0,
      bound = without_gait,
    },
    tests.cyclic {
      id = "S7c", statement = "Walkers with oscillators, NEAT: all gaits are cyclic", calibrated = true,
      section = "§3.1", paper = "0 of 20 are not", a = "osc-te-neat", level = late_share, count = 0,
      bound = without_gait,
    },
    tests.cyclic {
      id = "S7d", statement = "Walkers with oscillators, novelty: all gaits are cyclic", calibrated = true,
      section = "§3.1", paper = "0 of 20 are not", a = "osc-te-ns", level = late_share, count = 0,
      bound = without_gait,
    },
    tests.cyclic {
      id = "S7e", statement = "Swimmers with gene networks, NEAT: all gaits but one are cyclic", calibrated = true,
      section = "§3.1", paper = "1 of 20 is not", a = "grn-aq-neat", level = late_share, count = 1,
      bound = without_gait,
    },
    tests.cyclic {
      id = "S7f", statement = "Swimmers with gene networks, novelty: all gaits are cyclic", calibrated = true,
      section = "§3.1", paper = "0 of 20 are not", a = "grn-aq-ns", level = late_share, count = 0,
      bound = without_gait,
    },
    tests.cyclic {
      id = "S7g", statement = "Walkers with gene networks, NEAT: all gaits but one are cyclic", calibrated = true,
      section = "§3.1", paper = "1 of 20 is not", a = "grn-te-neat", level = late_share, count = 1,
      bound = without_gait,
    },
    tests.cyclic {
      id = "S7h", statement = "Walkers with gene networks, novelty: all gaits are cyclic", calibrated = true,
      section = "§3.1", paper = "0 of 20 are not", a = "grn-te-ns", level = late_share, count = 0,
      bound = without_gait,
    },

    -- §3.1: which search the best runs belong to. By chance the best three of 40 runs too often belong to one search: S9
    -- stays inconclusive whatever is found, S10 nearly so; the table says why.
    tests.top_runs {
      id = "S8", statement = "Swimmers with oscillators: the five best runs are novelty search's",
      section = "§3.1", paper = "5 of 5", a = "osc-aq-ns", b = "osc-aq-neat", count = 5,
    },
    tests.top_runs {
      id = "S9", statement = "Walkers with oscillators: the three best runs are novelty search's",
      section = "§3.1", paper = "3 of 3", a = "osc-te-ns", b = "osc-te-neat", count = 3,
    },
    tests.elongated {
      id = "S10", statement = "Swimmers with gene networks: the two best runs are NEAT's and their bodies elongated",
      section = "§3.1", paper = "2 of 2", a = "grn-aq-neat", b = "grn-aq-ns", count = 2,
    },

    -- §3.4: how the searches explore. Water: directions; land: which side the best so far runs to. The paper
    -- says of gene networks "qualitatively similar (not shown)".
    tests.direction {
      id = "S11a", statement = "Swimmers with oscillators: novelty search explores directions more evenly",
      section = "§3.4", paper = "Fig. 8", a = "osc-aq-ns", b = "osc-aq-neat", expect = "less",
    },
    tests.side_switches {
      id = "S11b", statement = "Walkers with oscillators: novelty search's best so far changes sides more often",
      section = "§3.4", paper = "Fig. 9", a = "osc-te-ns", b = "osc-te-neat", expect = "greater",
    },
    tests.direction {
      id = "S11c", statement = "Swimmers with gene networks: novelty search explores directions more evenly",
      section = "§3.4", paper = "not shown", a = "grn-aq-ns", b = "grn-aq-neat", expect = "less",
    },
    tests.side_switches {
      id = "S11d", statement = "Walkers with gene networks: novelty search's best so far changes sides more often",
      section = "§3.4", paper = "not shown", a = "grn-te-ns", b = "grn-te-neat",
      expect = "greater",
    },

    -- §3.5: the spread of fitness in the last generation, relative to the highest.
    tests.fitness_spread {
      id = "S12a", statement = "Swimmers with oscillators: fitness varies less with NEAT", calibrated = true,
      section = "§3.5", paper = "Fig. 11", a = "osc-aq-neat", b = "osc-aq-ns", expect = "less",
    },
    tests.fitness_spread {
      id = "S12b", statement = "Walkers with oscillators: fitness varies less with NEAT", calibrated = true,
      section = "§3.5", paper = "Fig. 11", a = "osc-te-neat", b = "osc-te-ns", expect = "less",
    },
    tests.fitness_spread {
      id = "S12c", statement = "Swimmers with gene networks: fitness varies less with NEAT", calibrated = true,
      section = "§3.5", paper = "Fig. 11", a = "grn-aq-neat", b = "grn-aq-ns", expect = "less",
    },
    tests.fitness_spread {
      id = "S12d", statement = "Walkers with gene networks: fitness varies less with NEAT", calibrated = true,
      section = "§3.5", paper = "Fig. 11", a = "grn-te-neat", b = "grn-te-ns", expect = "less",
    },

    -- §3.6: the diversity of body sizes over a run, Eq. (8). That the difference is larger with gene networks is to
    -- be read off the effects of S13c and S13d beside those of S13a and S13b.
    tests.size_entropy {
      id = "S13a", statement = "Swimmers with oscillators: novelty search makes more diverse sizes",
      section = "§3.6", paper = "Fig. 12", a = "osc-aq-ns", b = "osc-aq-neat", expect = "greater",
    },
    tests.size_entropy {
      id = "S13b", statement = "Walkers with oscillators: novelty search makes more diverse sizes",
      section = "§3.6", paper = "Fig. 12", a = "osc-te-ns", b = "osc-te-neat", expect = "greater",
    },
    tests.size_entropy {
      id = "S13c", statement = "Swimmers with gene networks: novelty search makes more diverse sizes",
      section = "§3.6", paper = "Fig. 12", a = "grn-aq-ns", b = "grn-aq-neat", expect = "greater",
    },
    tests.size_entropy {
      id = "S13d", statement = "Walkers with gene networks: novelty search makes more diverse sizes",
      section = "§3.6", paper = "Fig. 12", a = "grn-te-ns", b = "grn-te-neat", expect = "greater",
    },
  },
}, summary)
