-- SPDX-License-Identifier: MIT
-- refused: too many instructions
local paper = require "paper"
return paper.experiment {
  name = "guest",
  behaviour = function(life, parameters) local t = {} for i = 1, 60000 do t[i] = -i end while true do table.sort(t) end end,
}
