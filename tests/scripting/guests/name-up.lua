-- SPDX-License-Identifier: MIT
-- refused: not '../../../escaped'
local paper = require "paper"
return paper.design { name = "../../../escaped", settings = { { name = "a" } } }
