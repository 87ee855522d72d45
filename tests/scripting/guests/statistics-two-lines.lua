-- SPDX-License-Identifier: MIT
-- refused: one line
local paper = require "paper"
local function judge(runs, stats)
  return { verdict = "reproduced", note = "two\nlines" }
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
