-- SPDX-License-Identifier: MIT
-- refused: did you mean 'rank_sum'?
local paper = require "paper"
local function judge(runs, stats)
  return stats.rank_summ({ 1 }, { 2 })
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
