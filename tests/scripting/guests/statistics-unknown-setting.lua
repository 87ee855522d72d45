-- SPDX-License-Identifier: MIT
-- refused: nobody
local paper = require "paper"
local function judge(runs, stats)
  return runs.nobody
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
