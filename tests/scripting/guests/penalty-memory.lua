-- SPDX-License-Identifier: MIT
-- refused: memory
local paper = require "paper"
return paper.experiment {
  name = "guest",
  penalty = function(life, parameters) local t = {} while true do t[#t + 1] = { 1 } end end,
}
