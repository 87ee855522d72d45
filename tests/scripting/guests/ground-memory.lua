-- SPDX-License-Identifier: MIT
-- refused: too much memory
local paper = require "paper"
return paper.experiment {
  name = "guest",
  environment = paper.terrestrial { ground = {
    height = function(x) local t = {} while true do t[#t + 1] = { x } end end,
    from = 0, to = 100, step = 1,
  } },
}
