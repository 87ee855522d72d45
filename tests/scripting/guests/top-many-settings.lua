-- SPDX-License-Identifier: MIT
-- refused: too many instructions in all
local paper = require "paper"
for i = 1, 5e6 do end
local settings = {}
for i = 1, 60 do settings[i] = { name = "s" .. i } end
return paper.design { name = "guest", settings = settings }
