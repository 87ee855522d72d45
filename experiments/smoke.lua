-- SPDX-License-Identifier: MIT
-- All settings of the paper at a size that takes a minute: does everything work together? Its claims stay
-- open or inconclusive, as too little is run to judge them.
return planula.fill({
  name = "smoke",
  title = "Every setting, for a minute",
  parameters = { seeds = 2, population = 24, generations = 4 },
}, require "paper.replication")
