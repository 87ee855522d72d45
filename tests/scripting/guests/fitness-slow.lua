-- SPDX-License-Identifier: MIT
-- accepted
local paper = require "paper"
return paper.experiment {
  name = "guest",
  fitness = function() for i = 1, 4.5e6 do end return 1 end,
  behaviour = function() for i = 1, 4.5e6 do end return { 1 } end,
  penalty = function() for i = 1, 4.5e6 do end return 1 end,
}
