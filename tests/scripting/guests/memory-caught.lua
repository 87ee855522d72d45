-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local n = 0
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) pcall(function() n = n + 1 error("no") end) return 1 end,
}
