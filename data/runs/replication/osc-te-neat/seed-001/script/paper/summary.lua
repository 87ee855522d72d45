-- SPDX-License-Identifier: MIT
-- What is computed for every experiment: intervals and shares, without a claim.
return {
  confidence = "confidence",         -- coverage of bootstrap intervals (Fig. 6)
  resamples = "bootstrap_resamples", -- of an interval; draws of a permutation test
  interval_runs = 10,                -- of fewer runs no interval: it would cover far less than it says (decision 0015)
  significance = 0.05,               -- a p-value below this tells two groups apart (§3.2)
  sample_share = 0.01,               -- of all individuals of a run, drawn for Fig. 8 (§3.4)
  sample_least = 300,                -- of a run too small for that, so many
  fitness_classes = 20,              -- bars of the distribution in Fig. 11
  direction_distance = 1,            -- cells: who moved less has no direction (§3.4)
}
