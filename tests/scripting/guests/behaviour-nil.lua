-- SPDX-License-Identifier: MIT
-- refused: nil
local paper = require "paper"
return paper.experiment {
  name = "guest",
  behaviour = function(life, parameters) return nil end,
}
