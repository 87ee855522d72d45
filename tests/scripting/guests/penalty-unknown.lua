-- SPDX-License-Identifier: MIT
-- refused: life has no 'fitnes'
local paper = require "paper"
return paper.experiment {
  name = "guest",
  penalty = function(life, parameters) return life.fitnes end,
}
