-- SPDX-License-Identifier: MIT
-- refused: must lie within 1e+09
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = {
    height = function(x) return 1e300 end,
    from = 0, to = 100, step = 1,
  } },
}
