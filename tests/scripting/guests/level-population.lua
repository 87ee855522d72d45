-- SPDX-License-Identifier: MIT
-- refused: parameters = { population = 40 }
local paper = require "paper"
return paper.experiment {
  name = "guest",
  population = 40,
}
