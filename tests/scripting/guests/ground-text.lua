-- SPDX-License-Identifier: MIT
-- refused: must return a finite number
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = {
    height = function(x) return "0" end,
    from = 0, to = 100, step = 1,
  } },
}
