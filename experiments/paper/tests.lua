-- SPDX-License-Identifier: MIT
-- The tests by which the paper's claims are judged (paper/decisions/0015-statistics.md). Each takes a claim with the
-- options of the test and returns the claim with its function `judge`:
--
--   tests.best_at_generation { id = "S1", …, a = "osc-aq-ns", b = "osc-aq-neat", generation = 2000, expect = "greater" }
--
-- Every p is two-sided unless said otherwise, and every verdict needs one below the significance: where so few runs
-- cannot give that, the claim is inconclusive and its note says so.
local tests = {}

-- Takes the options from a claim: a copy of the claim without them, and the options.
local function split(statement, test, options)
  if type(statement) ~= "table" then error("tests." .. test .. " takes a claim, a table", 3) end
  local claim, taken = { test = test }, {}
  for key, value in pairs(statement) do claim[key] = value end
  for _, key in ipairs(options) do
    taken[key] = claim[key]
    claim[key] = nil
  end
  return claim, taken
end

-- `level` as of error(): 3 names the line that calls the test.
local function need(condition, statement, rule, level)
  if not condition then error("claim '" .. tostring(statement.id) .. "': " .. rule, level or 3) end
end

local function is_between(value, low, high)
  return type(value) == "number" and value > low and value < high
end

local function is_count(value, least)
  return type(value) == "number" and value >= least and value < math.huge and value == math.floor(value)
end

-- Why nothing is concluded, if no p that so few runs can give would do.
local function explain(finding, least, of_what, stats)
  if finding.verdict ~= "inconclusive" or least < stats.significance then return end
  finding.note = "of so few runs p" .. of_what .. " is at least " .. math.floor(least * 1000 + 0.5) / 1000
end

-- Adds a bootstrap interval of the statistic; none if there are too few runs.
local function add_interval(finding, a, b, statistic, stats)
  if math.min(#a, #b) < stats.interval_runs then return end
  local interval = stats.bootstrap(a, b, statistic)
  finding.low, finding.high = interval.low, interval.high
end

-- ---- Rank-sum tests of a against b: A12 with bootstrap interval ----

-- The runs that have the value; how many do not is added to the notes.
local function present(setting, values, stats, notes)
  local known = stats.present(values)
  if #known < #values then
    notes[#notes + 1] = (#values - #known) .. " runs of " .. setting.name .. " have no such value"
  end
  return known
end

-- Expecting greater or less, a significant difference with A12 beyond 1/2 on that side reproduces, on the other side
-- contradicts. Expecting no difference, the test of equivalence reproduces: a difference that is not significant does
-- not show that there is none. Without equivalence, a significant difference contradicts.
local function rank_verdict(expect, finding, stats)
  local differs = finding.p < stats.significance
  if expect == "no_difference" then
    if finding.p_equivalence < stats.significance then return "reproduced" end
    return differs and "contradicted" or "inconclusive"
  end
  if not differs or finding.effect == 0.5 then return "inconclusive" end
  return (finding.effect > 0.5) == (expect == "greater") and "reproduced" or "contradicted"
end

local function compare(a, b, options, stats)
  local test = stats.rank_sum(a, b)
  local finding = { effect_name = "A12", effect = stats.a12(a, b), p = test.p, method = test.method }
  add_interval(finding, a, b, stats.a12, stats)
  local least, of_what = test.least, ""
  if options.expect == "no_difference" then
    local same = stats.equivalence(a, b, options.bound)
    finding.p_equivalence = same.p
    least, of_what = same.least, " of equivalence"
  end
  finding.verdict = rank_verdict(options.expect, finding, stats)
  explain(finding, least, of_what, stats)
  return finding
end

-- A test that compares one value of each run: measure(setting, generations) is the list of these values.
local function rank_test(name, measure)
  return function(statement)
    local claim, options = split(statement, name, { "expect", "bound" })
    need(options.expect == "greater" or options.expect == "less" or options.expect == "no_difference", statement,
      "expect must be 'greater', 'less' or 'no_difference', not " .. tostring(options.expect))
    if options.expect == "no_difference" then
      need(is_between(options.bound, 0, 0.5), statement,
        "no_difference needs a bound above 0 and below 0.5, how far A12 may be from 1/2, not " .. tostring(options.bound))
    else
      need(options.bound == nil, statement, "only no_difference has a bound")
    end

    function claim.judge(runs, stats, this)
      local notes = {}
      local of_a, of_b = runs[this.a], runs[this.b]
      local a = present(of_a, measure(of_a, this.at_generation), stats, notes)
      local b = present(of_b, measure(of_b, this.at_generation), stats, notes)
      local finding = { effect_name = "A12", verdict = "inconclusive" }
      if #a > 0 and #b > 0 then finding = compare(a, b, options, stats) end
      notes[#notes + 1] = finding.note
      if #notes > 0 then finding.note = notes[1] end
      for i = 2, #notes do finding.note = finding.note .. "; " .. notes[i] end
      return finding
    end
    return claim
  end
end

-- The best fitness in that generation.
tests.best_at_generation = rank_test("best_at_generation", function(setting, generations)
  return setting.best_fitness[generations]
end)

-- Eq. (8) over the history up to that generation.
tests.size_entropy = rank_test("size_entropy", function(setting, generations)
  return setting.size_entropy[generations]
end)

-- The interquartile range of fitness in that generation, over its highest fitness.
tests.fitness_spread = rank_test("fitness_spread", function(setting, generations)
  return setting.fitness_spread[generations]
end)

-- The mean resultant length of the end directions up to that generation.
tests.direction = rank_test("direction", function(setting, generations)
  return setting.direction_resultant[generations]
end)

-- How often the best so far changed sides up to that generation.
tests.side_switches = rank_test("side_switches", function(setting, generations)
  return setting.side_switches[generations]
end)

-- ---- The permutation test ----

-- Of each run the best fitness of the first generations.
local function curves(setting, generations)
  local all = {}
  for _, run in ipairs(setting) do
    local series, curve = run.best_fitness, {}
    for generation = 1, generations do curve[generation] = series[generation] end
    all[#all + 1] = curve
  end
  return all
end

local function means(all, stats)
  local result = {}
  for i, curve in ipairs(all) do result[i] = stats.mean(curve) end
  return result
end

-- The share of generations in which the mean best of a is at least that of b, with bootstrap interval; p: of the
-- difference of the means over all generations. With a significant p, a ahead by that mean and a share of at least
-- `level` reproduce, b ahead contradicts.
function tests.mean_ahead(statement)
  local claim, options = split(statement, "mean_ahead", { "level" })
  need(is_between(options.level, 0, 1) or options.level == 1, statement,
    "level must be above 0 and at most 1, not " .. tostring(options.level))

  function claim.judge(runs, stats, this)
    local a, b = curves(runs[this.a], this.at_generation), curves(runs[this.b], this.at_generation)
    local finding = { effect_name = "share of generations ahead", effect = stats.share_ahead(a, b) }
    add_interval(finding, a, b, stats.share_ahead, stats)
    local test = stats.permutation(means(a, stats), means(b, stats))
    finding.p, finding.method, finding.verdict = test.p, test.method, "inconclusive"
    if test.p < stats.significance then
      if test.difference < 0 then finding.verdict = "contradicted" end
      if test.difference > 0 and finding.effect >= options.level then finding.verdict = "reproduced" end
    end
    explain(finding, test.least, "", stats)
    return finding
  end
  return claim
end

-- ---- Counts, with exact p ----

-- The runs of both settings: the fitness and elongation of their champions, and whether they are a's.
local function champions(runs, claim)
  local all = {}
  for _, name in ipairs { claim.a, claim.b } do
    local fitness = runs[name].champion.fitness[claim.at_generation]
    local elongation = runs[name].champion.elongation[claim.at_generation]
    for i = 1, #fitness do
      all[#all + 1] = { fitness = fitness[i], elongation = elongation[i], of_a = name == claim.a }
    end
  end
  return all
end

-- How many of the best `count` are of the kind that a claim is about, if of equal fitness those that are not come first,
-- or those that are.
local function count_best(all, count, kind_first)
  table.sort(all, function(x, y)
    if x.fitness ~= y.fitness then return x.fitness > y.fitness end
    return x.kind ~= y.kind and x.kind == kind_first
  end)
  local found = 0
  for i = 1, count do if all[i].kind then found = found + 1 end end
  return found
end

-- All of the best `wanted` reproduce, fewer than half contradict. Equal fitness counts against either verdict.
function tests.top_verdict(least, most, wanted, p, significance)
  if p >= significance then return "inconclusive" end
  if least == wanted then return "reproduced" end
  return 2 * most < wanted and "contradicted" or "inconclusive"
end

local function judge_best(all, wanted, effect_name, stats)
  local total, kind = #all, 0
  for _, champion in ipairs(all) do if champion.kind then kind = kind + 1 end end
  local count = math.min(wanted, total)
  local least, most = count_best(all, count, false), count_best(all, count, true)
  local function two_sided(at_least, at_most)
    local so_many = stats.hypergeometric(at_least, total, kind, count)
    local so_few = stats.hypergeometric(count - at_most, total, total - kind, count)
    return math.min(1, 2 * math.min(so_many, so_few))
  end
  local finding = { effect_name = effect_name, effect = least, p = two_sided(least, most), method = "exact" }
  finding.verdict = tests.top_verdict(least, most, wanted, finding.p, stats.significance)
  explain(finding, two_sided(math.min(count, kind), math.max(0, count + kind - total)), "", stats)
  return finding
end

local function need_count(options, statement)
  need(is_count(options.count, 1), statement,
    "count must be a whole number of at least 1, not " .. tostring(options.count), 4)
end

-- How many of the best `count` runs of both are a's.
function tests.top_runs(statement)
  local claim, options = split(statement, "top_runs", { "count" })
  need_count(options, statement)

  function claim.judge(runs, stats, this)
    local all = champions(runs, this)
    for _, champion in ipairs(all) do champion.kind = champion.of_a end
    return judge_best(all, options.count, "a's runs among the best " .. options.count, stats)
  end
  return claim
end

-- How many of the best `count` runs of both are a's and have a champion more elongated than the median of all runs.
function tests.elongated(statement)
  local claim, options = split(statement, "elongated", { "count" })
  need_count(options, statement)

  function claim.judge(runs, stats, this)
    local all, elongations = champions(runs, this), {}
    for i, champion in ipairs(all) do elongations[i] = champion.elongation end
    local usual = stats.median(elongations)
    for _, champion in ipairs(all) do champion.kind = champion.of_a and champion.elongation > usual end
    return judge_best(all, options.count, "a's and elongated among the best " .. options.count, stats)
  end
  return claim
end

-- The original had so many runs of each setting.
local original_runs = planula.parameters.seeds

-- Runs of a whose champion made less than `level` of its way, or of its muscles' changes, in the last quarter: a body
-- that falls over once makes no distance late; one that contracts once and glides has no late actuation. At most `count`
-- reproduce if they show that the share of such runs is below `bound` (one-sided binomial test, the p of equivalence);
-- more contradict if they are too many beside the original's `count` (p: Fisher's exact test, one-sided).
function tests.cyclic(statement)
  local claim, options = split(statement, "cyclic", { "level", "count", "bound" })
  need(is_between(options.level, 0, 1) or options.level == 1, statement,
    "level must be above 0 and at most 1, not " .. tostring(options.level))
  need(is_count(options.count, 0), statement,
    "count must be a whole number of at least 0, not " .. tostring(options.count))
  need(is_between(options.bound, 0, 1), statement,
    "bound must be above 0 and below 1, the share of runs without a cyclic gait, not " .. tostring(options.bound))

  function claim.judge(runs, stats, this)
    local champion, found = runs[this.a].champion, 0
    local way, actuation = champion.late_share[this.at_generation], champion.late_actuation[this.at_generation]
    for i = 1, #way do
      if math.min(way[i], actuation[i]) < options.level then found = found + 1 end
    end

    -- The original's runs and ours together: how often would chance give ours this many?
    local ours = #way
    local stuck = found + math.min(options.count, original_runs)
    local finding = {
      effect_name = "runs without a cyclic gait", effect = found, method = "exact", verdict = "inconclusive",
      p = stats.hypergeometric(found, ours + original_runs, stuck, ours),
      p_equivalence = stats.binomial(found, ours, options.bound),
    }
    if found > options.count and finding.p < stats.significance then finding.verdict = "contradicted" end
    if found <= options.count and finding.p_equivalence < stats.significance then finding.verdict = "reproduced" end
    explain(finding, stats.binomial(0, ours, options.bound), " of equivalence", stats)
    return finding
  end
  return claim
end

return tests
