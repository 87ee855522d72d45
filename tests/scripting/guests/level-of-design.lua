-- SPDX-License-Identifier: MIT
-- refused: write in the setting: search = "novelty"
local paper = require "paper"
return paper.design { name = "guest", search = "novelty", settings = { { name = "a" } } }
