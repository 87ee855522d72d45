-- SPDX-License-Identifier: MIT
-- refused: too many instructions
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = {
    height = function(x) while true do end end,
    from = 0, to = 100, step = 1,
  } },
}
