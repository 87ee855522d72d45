-- SPDX-License-Identifier: MIT
-- refused: 1 to 100
local paper = require "paper"
return paper.design { name = "", settings = { { name = "a" } } }
