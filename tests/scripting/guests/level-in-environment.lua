-- SPDX-License-Identifier: MIT
-- refused: write in the setting: parameters = { spring_damping = 4 }
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.aquatic { spring_damping = 4 },
}
