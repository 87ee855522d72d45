-- SPDX-License-Identifier: MIT
-- refused: too many instructions
local paper = require "paper"
local function judge(runs, stats)
  while true do end
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
