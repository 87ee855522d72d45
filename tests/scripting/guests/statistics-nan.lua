-- SPDX-License-Identifier: MIT
-- refused: nan
local paper = require "paper"
local function judge(runs, stats)
  return stats.mean({ 0 / 0 })
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
