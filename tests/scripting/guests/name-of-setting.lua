-- SPDX-License-Identifier: MIT
-- refused: not '../a'
local paper = require "paper"
return paper.design { name = "guest", settings = { { name = "../a" } } }
