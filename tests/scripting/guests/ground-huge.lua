-- SPDX-License-Identifier: MIT
-- refused: must give 2 … 100000 points
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = {
    height = function(x) return 0 end,
    from = -1e300, to = 1e300, step = 1e-300,
  } },
}
