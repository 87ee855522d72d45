-- SPDX-License-Identifier: MIT
-- accepted
local paper = require "paper"
if tostring({}) ~= "table" or tostring(paper.experiment) ~= "function" then error("an address") end
return paper.experiment { name = "guest" }
