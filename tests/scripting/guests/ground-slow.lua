-- SPDX-License-Identifier: MIT
-- refused: too many instructions in all
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = {
    height = function(x) for i = 1, 1e6 do end return 0 end,
    from = 0, to = 99998, step = 1,
  } },
}
