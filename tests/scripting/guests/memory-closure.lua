-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local function counter() local n = 0 return function() n = n + 1 return n end end
local next_number = counter()
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) return next_number() end,
}
