-- SPDX-License-Identifier: MIT
-- refused: hostile/endless.lua:2:
local paper = require "paper"
return paper.experiment { name = "guest", fitness = function() return require("hostile.endless").x end }
