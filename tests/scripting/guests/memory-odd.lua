-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local n = 0
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) n = n + 1 return (n > 1 and n % 2 == 1) and 0.5 or 1 end,
}
