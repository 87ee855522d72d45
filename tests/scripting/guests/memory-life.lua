-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local kept
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) kept = kept or life return kept.cells end,
}
