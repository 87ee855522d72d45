-- SPDX-License-Identifier: MIT
-- refused: environment = { drag = { normal = 2 } }
local paper = require "paper"
return paper.experiment {
  name = "guest",
  normal = 2,
}
