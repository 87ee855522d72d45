-- SPDX-License-Identifier: MIT
-- refused: not a table with a verdict
local paper = require "paper"
local function judge(runs, stats)
  return 5
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
