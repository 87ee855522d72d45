-- SPDX-License-Identifier: MIT
-- accepted
local paper = require "paper"
local zero = 0 * -1
if tostring(zero) ~= "0" or string.format("%g", zero) ~= "0" then error("a sign") end
if math.atan2(zero, -1) < 0 or 1 / math.ceil(-0.5) < 0 then error("a sign") end
return paper.experiment { name = "guest", behaviour = function(life) return { life.cells * -0 } end }
