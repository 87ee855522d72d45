-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) local d = require "descriptors" d.last = life.cells return 1 end,
}
