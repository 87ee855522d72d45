-- SPDX-License-Identifier: MIT
-- refused: life has no 'kkkk
local paper = require "paper"
return paper.experiment {
  name = "guest",
  start = { generations = 2, behaviour = function(life, parameters) return life[("k"):rep(2e6)] end },
}
