-- SPDX-License-Identifier: MIT
-- refused: ground
local paper = require "paper"
local points = {}
for i = 1, 60000 do points[i] = { i } end
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = points },
}
