-- SPDX-License-Identifier: MIT
-- refused: no ground here
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = {
    height = function(x) error("no ground here") end,
    from = 0, to = 100, step = 1,
  } },
}
