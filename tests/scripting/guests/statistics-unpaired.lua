-- SPDX-License-Identifier: MIT
-- refused: signed_rank
local paper = require "paper"
local function judge(runs, stats)
  return stats.signed_rank({ 1, 2 }, { 3 })
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
