-- SPDX-License-Identifier: MIT
-- How much do the results depend on the values that the paper does not give? Evolves all its settings at its
-- population, for few generations; then simulates a sample of what evolved with each of those values halved and
-- doubled:
--   make sensitivity
return planula.fill({
  name = "sensitivity",
  title = "Evolved animats under other values",
  parameters = { seeds = 1, generations = 100 },
  sensitivity = { sample = 200, factors = { 0.5, 2 } },
}, require "paper.replication")
