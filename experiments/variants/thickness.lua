-- SPDX-License-Identifier: MIT
-- A question with statistics of its own: do swimmers get farther in thin water than in thick water? The function
-- `judge` answers it with a verdict in claims.csv; the function `medians` makes the table medians.csv. Both see the runs
-- of each setting as lists, one value for each run, after any number of generations.
local paper = require "paper"

local function judge(runs, stats, claim)
  local thin = runs.thin.champion.displacement[claim.at_generation]
  local thick = runs.thick.champion.displacement[claim.at_generation]
  local test = stats.rank_sum(thin, thick)
  local effect = stats.a12(thin, thick)
  local verdict = "inconclusive"
  if test.p < stats.significance then verdict = effect > 0.5 and "reproduced" or "contradicted" end
  return { verdict = verdict, effect_name = "A12", effect = effect, p = test.p, method = test.method }
end

local function medians(runs, stats)
  local rows = { columns = { "setting", "generation", "median", "low", "high" } }
  for _, setting in ipairs(runs) do
    for generation = 10, setting.generations, 10 do
      local best = setting.best_fitness[generation]
      local interval = stats.bootstrap(best, stats.median)
      rows[#rows + 1] = {
        setting = setting.name, generation = generation, median = stats.median(best),
        low = interval.low, high = interval.high,
      }
    end
  end
  return rows
end

return paper.design {
  name = "thickness",
  title = "Thin and thick water",
  settings = {
    { name = "thin" },
    { name = "thick", environment = paper.aquatic { drag = { normal = 8.0, tangential = 0.8 } } },
  },
  statistics = planula.fill({
    claims = {
      { id = "H1", statement = "Swimmers get farther in thin water", a = "thin", b = "thick", judge = judge },
    },
    tables = { medians = medians },
  }, require "paper.summary"),
}
