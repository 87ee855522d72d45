-- SPDX-License-Identifier: MIT
-- refused: 1 to 100 letters
local paper = require "paper"
return paper.design { name = "/" .. "x", settings = { { name = "a" } } }
