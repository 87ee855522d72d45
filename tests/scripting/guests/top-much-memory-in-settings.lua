-- SPDX-License-Identifier: MIT
-- accepted
local paper = require "paper"
local big = ("x"):rep(1e7)
local settings = {}
for i = 1, 30 do settings[i] = { name = "s" .. i, fitness = function(life) return #big end } end
return paper.design { name = "guest", settings = settings }
