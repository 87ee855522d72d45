-- SPDX-License-Identifier: MIT
-- refused: returned the verdict '', which is not one of
local paper = require "paper"
local function judge(runs, stats)
  return {}
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
