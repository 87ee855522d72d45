-- SPDX-License-Identifier: MIT
-- refused: environment = { drag = … }
local paper = require "paper"
return paper.experiment {
  name = "guest",
  drag = { normal = 1, tangential = 1 },
}
