-- SPDX-License-Identifier: MIT
-- refused: xxx
local paper = require "paper"
local function judge(runs, stats)
  error(("x"):rep(3e6))
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
