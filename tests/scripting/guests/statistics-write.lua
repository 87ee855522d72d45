-- SPDX-License-Identifier: MIT
-- refused: read-only
local paper = require "paper"
local function judge(runs, stats)
  runs.x = 1
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
