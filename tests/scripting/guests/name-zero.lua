-- SPDX-License-Identifier: MIT
-- refused: one line
local paper = require "paper"
return paper.design { name = "a\0b", settings = { { name = "a" } } }
