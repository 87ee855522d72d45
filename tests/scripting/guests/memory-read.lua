-- SPDX-License-Identifier: MIT
-- accepted
local paper = require "paper"
local t = { 1, 2, 3 }
return paper.experiment {
  name = "guest",
  fitness = function(life, parameters) local sum = 0 for _, x in ipairs(t) do sum = sum + x end return sum end,
}
