-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local t = {}
for i = 1, 5000 do t[i] = i end
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) t[life.cells + 1] = 0 return 1 end,
}
