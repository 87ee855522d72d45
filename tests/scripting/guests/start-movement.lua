-- SPDX-License-Identifier: MIT
-- refused: growth alone
local paper = require "paper"
return paper.experiment {
  name = "guest",
  start = { generations = 2, behaviour = function(life) return { life.finish.x } end },
}
