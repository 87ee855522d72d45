-- SPDX-License-Identifier: MIT
-- All settings of the paper at a size that takes a minute, to see whether everything works together. Its claims stay
-- open or inconclusive, since too little is run to judge them.
return planula.fill({
  name = "smoke",
  title = "Every setting, for a minute",
  parameters = { seeds = 2, population = 24, generations = 4 },
}, require "paper.replication")
