-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local t = {}
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) t[#t + 1] = 1 return #t end,
}
