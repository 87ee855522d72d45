-- SPDX-License-Identifier: MIT
-- refused: is {x, y}, two numbers
local paper = require "paper"
local points = {}
for i = 1, 150000 do points[i] = "x" end
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = points },
}
