-- SPDX-License-Identifier: MIT
-- refused: these are the first 100 problems
local paper = require "paper"
local p = {}
for i = 1, 20000 do p["key" .. i] = i end
return paper.experiment { name = "guest", parameters = p }
