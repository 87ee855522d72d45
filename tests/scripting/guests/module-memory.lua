-- SPDX-License-Identifier: MIT
-- refused: what it closes over
local paper = require "paper"
local counter = require "hostile.counter"
return paper.experiment { name = "guest", fitness = counter.count }
