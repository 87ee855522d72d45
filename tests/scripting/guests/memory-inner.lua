-- SPDX-License-Identifier: MIT
-- accepted
local paper = require "paper"
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) local n = 0 local function add() n = n + 1 end add() return n end,
}
