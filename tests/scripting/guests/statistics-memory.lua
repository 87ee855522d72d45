-- SPDX-License-Identifier: MIT
-- refused: memory
local paper = require "paper"
local function judge(runs, stats)
  local t = {} while true do t[#t + 1] = { 1 } end
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
