-- SPDX-License-Identifier: MIT
-- refused: stack overflow
local paper = require "paper"
local function judge(runs, stats)
  local function f() return 1 + f() end return f()
end
return paper.experiment {
  name = "guest",
  statistics = planula.fill({ claims = { { id = "A", statement = "s", a = "guest", judge = judge } } }, require "paper.summary"),
}
