-- SPDX-License-Identifier: MIT
-- refused: a list of 1 … 16 numbers
local paper = require "paper"
return paper.experiment {
  name = "guest",
  behaviour = function() local t = {} for i = 1, 17 do t[i] = 0 end return t end,
}
