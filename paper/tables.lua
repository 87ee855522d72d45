-- SPDX-License-Identifier: MIT
-- The numbers and tables of paper.tex that come from data, so that none is typed by hand. Functions either return TeX
-- text or print a table environment; an absent value shows as a dash. open() is called first, with the folder of the
-- reduced tables. The power of the statistical tests is read from tests/power.
local csv = require 'csv'
local typeset = require 'typeset'
local escape, show, short, percent_of = typeset.escape, typeset.show, typeset.short, typeset.percent_of
local row_of, print_tabular = typeset.row_of, typeset.print_tabular
local tables = {}
local data, simulated
local decisions_folder, rules_file = 'paper/decisions', 'paper/sections/rules.tex'

-- ---- Data ----

-- Reads every table once.
function tables.open(data_folder)
  data, simulated = {}, {}
  for _, name in ipairs { 'power', 'coverage' } do simulated[name] = csv.read('tests/power/' .. name .. '.csv') end
  data.manifest = csv.pairs_of(data_folder .. '/manifest.csv')
  for _, name in ipairs { 'settings', 'runs', 'curves', 'heredity', 'entropy', 'outcomes', 'parameters', 'endpoints', 'endpoint_density' } do
    data[name] = csv.read(data_folder .. '/' .. name .. '.csv')
  end
  -- Tables that a separate command makes; the data may lack them.
  for _, name in ipairs { 'engines', 'witness', 'sensitivity', 'searches', 'readings', 'robustness' } do
    local file = data_folder .. '/' .. name .. '.csv'
    data[name] = lfs.isfile(file) and csv.read(file) or {}
  end
  data.parameter = {}
  for _, row in ipairs(data.parameters) do data.parameter[row.name] = row end
end

function tables.manifest(key) return typeset.in_words(assert(data.manifest[key], 'manifest.csv has no ' .. key)) end
-- A share of the manifest in per cent: 11.1. What the original draws in Figure 8, beside what is drawn here.
function tables.manifest_percent(key) return (percent_of(data.manifest[key]):gsub('%.0$', '')) end
function tables.share_drawn()
  local same = tonumber(data.manifest.endpoint_share) <= 0.01
  return same and 'shows as many' or 'shows 1\\,\\% (too few points for such short runs)'
end
function tables.version() return escape(data.manifest.version) end

-- The value of a parameter in the replication, by its name in the table of parameters.
function tables.parameter(name)
  return typeset.literal(assert(data.parameter[name], 'parameters.csv has no ' .. name).standard)
end

-- The same as a percentage: 40.
function tables.percent(name) return show(100 * tonumber(data.parameter[name].standard)) end

-- The longest period of a muscle in steps; how many individuals of a setting's best run Figure 9 rests on, of all.
function tables.longest_period() return show(data.parameter.period_longest.standard) end
function tables.recorded_ends(setting)
  local count = 0
  for _, row in ipairs(csv.where(data.endpoint_density, { setting = setting, role = 'best' })) do count = count + tonumber(row.recorded) end
  return show(count)
end

-- A number of the run of a setting that Figures 8 and 9 show as its best or median one; the same of all runs of the
-- setting: their median, and the lowest and highest.
function tables.shown_run(setting, role, column)
  local point = csv.where(data.endpoints, { setting = setting, role = role })[1]
  local run = point and csv.where(data.runs, { setting = setting, seed = point.seed })[1]
  return run and show(run[column]) or '--'
end
function tables.all_runs(setting, column)
  local values = csv.numbers(csv.where(data.runs, { setting = setting }), column)
  local middle = csv.median(values) -- sorts them
  return #values > 0 and ('%s (%s to %s)'):format(show(middle), show(values[1]), show(values[#values])) or '--'
end

-- The elongation of the best individuals of the best three runs of a setting, the fittest first: 8.1, 7.9 and 3.0.
function tables.elongations(setting)
  local runs = csv.where(data.runs, { setting = setting })
  table.sort(runs, function(a, b)
    local first, second = tonumber(a.best_fitness), tonumber(b.best_fitness)
    return first > second or (first == second and tonumber(a.seed) < tonumber(b.seed))
  end)
  local shown = {}
  for rank = 1, math.min(3, #runs) do shown[rank] = ('%.1f'):format(tonumber(runs[rank].elongation)) end
  local last = table.remove(shown)
  return #shown > 0 and table.concat(shown, ', ') .. ' and ' .. last or last or '--'
end

-- ---- Rules ----

-- The decisions, one page each, in order.
local function decisions()
  local names = {}
  for name in lfs.dir(decisions_folder) do
    if name:match '^%d%d%d%d%-.*%.md$' then names[#names + 1] = name end
  end
  table.sort(names)
  return names
end

-- The origin of a rule, as rules.tex states it; four digits are a decision, whose page must exist.
function tables.origin(text)
  local pages = table.concat(decisions(), '\n')
  return (text:gsub('%f[%d]%d%d%d%d%f[%D]', function(page)
    assert(pages:find('%f[%d]' .. page .. '%-'), decisions_folder .. ' has no page ' .. page)
    return ('\\hyperlink{page:%s}{%s}'):format(page, page)
  end))
end

-- For each parameter, the numbers of the rules that use it.
local function rules_by_parameter()
  local rules, rule = {}, nil
  for command, name in io.open(rules_file):read('a'):gmatch '\\(%a+){([%w_]+)}' do
    if command == 'law' then
      rule = name
    elseif rule and (command == 'parameter' or command == 'percent' or command == 'choice') then
      local all = rules[name] or {}
      rules[name] = all
      if all[#all] ~= rule then all[#all + 1] = rule end
    end
  end
  return rules
end

-- How much of the planned design the data hold.
function tables.size_of_data()
  local planned = data.manifest
  if planned.complete == '1' then
    return ('This copy is based on the complete design: %s seeds of each of %s settings, %s generations of %s individuals; %s evaluations.')
      :format(show(planned.seeds), show(planned.settings), show(planned.generations), show(planned.population),
              typeset.in_words(planned.evaluations))
  end
  local function of(key)
    local there, all = show(planned[key]), show(planned[key .. '_planned'])
    return there == all and 'all ' .. there or there .. ' of ' .. all
  end
  return ('This copy is based on a part of the planned design: %s seeds, %s generations, %s individuals in each of %s settings; %s of %s evaluations.')
    :format(of 'seeds', of 'generations', of 'population', show(planned.settings), show(planned.evaluations),
            typeset.in_words(planned.evaluations_planned))
end

function tables.is_complete() return data.manifest.complete == '1' end

-- What that means for the claims, if the data do not cover the design.
function tables.caution()
  if tables.is_complete() then return '' end
  local text = data.manifest.generations == data.manifest.generations_planned and '' or 'The figures show the first generations of evolution. '
  text = text .. 'Every claim has two verdicts: one from these runs and generations, and one at the size of the original, '
    .. 'which is open as long as the data are smaller.'
  local runs = tonumber(data.manifest.seeds)
  local least = tables.least_p(runs, runs)
  if least < 0.05 then return text end
  return text .. (' With %s runs of each setting a rank-sum test cannot give a $p$ below %s: no difference can be decided.')
    :format(show(runs), typeset.probability(least))
end

-- A sentence on how many generations the data have of those planned.
function tables.of_generations()
  local there, planned = data.manifest.generations, data.manifest.generations_planned
  if there == planned then return ('The data have all %s generations.'):format(show(planned)) end
  return ('The data of this copy end after %s of %s generations.'):format(show(there), show(planned))
end

-- The smallest two-sided p that a rank-sum test of m values against n can give: two of all ways to share them out.
function tables.least_p(m, n)
  local ways = 1
  for i = 1, n do ways = ways * (m + i) / i end
  return math.min(1, 2 / ways)
end

-- Mean best fitness of a setting in its last generation, with its interval.
function tables.final_fitness(setting)
  local rows = csv.where(data.curves, { setting = setting })
  return #rows > 0 and typeset.interval(rows[#rows], 'mean') or '--'
end

function tables.entropy(setting)
  local rows = csv.where(data.entropy, { setting = setting })
  return #rows > 0 and typeset.interval(rows[1], 'mean') or '--'
end

-- Mother-offspring correlation of fitness in a setting's last generation, median of the runs.
function tables.heredity(setting)
  local rows = csv.where(data.heredity, { setting = setting })
  local value = #rows > 0 and tonumber(rows[#rows].heredity_fitness)
  return value and (('%.2f'):format(value):gsub('^%-', '$-$')) or '--'
end

-- The share of cyclic gaits in the last generation of a setting.
function tables.cyclic_share(setting)
  local rows = csv.where(data.heredity, { setting = setting })
  return #rows > 0 and ('%s\\,\\%%'):format(percent_of(rows[#rows].cyclic)) or '--'
end

-- The number of rows of a table; whether it has any.
function tables.rows(name) return tostring(#data[name]) end
function tables.has(name) return #data[name] > 0 end

-- Includes a section if the table that it reports has rows.
function tables.input_with(name, file)
  if tables.has(name) then tex.print('\\input{' .. file .. '}') end
end

-- A count of all settings' champions: champions or flagged.
function tables.witnessed(column)
  local count = 0
  for _, row in ipairs(data.engines) do count = count + tonumber(row[column]) end
  return show(count)
end

-- The highest speed of a node within a champion whose muscles hold still.
function tables.largest_unrest()
  local most = 0
  for _, row in ipairs(data.engines) do most = math.max(most, tonumber(row.held_unrest_largest) or 0) end
  return show(most)
end

-- The lowest and the highest rank correlation of a setting; settings with too few champions have none.
function tables.rank_correlations()
  local low, high
  for _, row in ipairs(data.engines) do
    local rho = tonumber(row.rank_correlation)
    if rho then low, high = math.min(low or rho, rho), math.max(high or rho, rho) end
  end
  if not low then return 'not known, because no setting has enough champions' end
  return low == high and show(low) or ('between %s and %s'):format(show(low), show(high))
end

-- The number of parameters with a given origin; 'paper' stands for its sections, equations and figures.
function tables.parameters_from(origin)
  local count = 0
  for _, row in ipairs(data.parameters) do
    local paper = row.origin:find '§' or row.origin:find 'Eq' or row.origin:find 'Fig'
    if (origin == 'paper' and paper) or row.origin == origin then count = count + 1 end
  end
  return tostring(count)
end

-- ---- Power of the tests ----

-- How often, in per cent, an interval from this number of runs contains the true value.
function tables.coverage(interval, values, runs)
  local rows = csv.where(simulated.coverage, { interval = interval, values = values, runs = tostring(runs) })
  return ('%.0f'):format(100 * tonumber(assert(rows[1], 'coverage.csv has no such row').covered))
end

-- How often, in per cent, a test reproduces a claim under this truth.
function tables.power(test, truth)
  local rows = csv.where(simulated.power, { test = test, truth = truth })
  return ('%.0f'):format(100 * tonumber(assert(rows[1], 'power.csv has no such row').reproduced))
end

function tables.power_repetitions() return show(simulated.power[1].repetitions) end

-- How often the tests of the claims reproduce or contradict a claim.
function tables.print_power()
  local head = { ' & & \\multicolumn{2}{c}{$p$ alone} & \\multicolumn{2}{c}{corrected $p$} \\\\', '\\cmidrule(lr){3-4}\\cmidrule(l){5-6}',
    'test & truth & repr. & contr. & repr. & contr. \\\\\\midrule' }
  local lines = { '\\begin{longtable}{@{}llrrrr@{}}',
    '\\caption{Power of the tests of the claims: how often, in per cent, they reproduce (repr.) or contradict (contr.) a claim when the truth is known, with 20 runs of each setting, in '
    .. tables.power_repetitions() .. ' simulations of each row. Truth: $A_{12}$ of normally distributed values unless stated otherwise, or the share of runs without a cyclic gait. Left: decided by the $p$ of the claim alone. '
    .. 'Right: decided by $p$ corrected over all of Table~\\ref{tab:claims}, if no other $p$ is small.}\\label{tab:power}\\\\', '\\toprule' }
  table.move(head, 1, #head, #lines + 1, lines)
  lines[#lines + 1] = '\\endfirsthead\\toprule'
  table.move(head, 1, #head, #lines + 1, lines)
  lines[#lines + 1] = '\\endhead\\bottomrule\\endfoot'
  local previous
  for _, row in ipairs(simulated.power) do
    if previous and row.test ~= previous then lines[#lines + 1] = '\\addlinespace[2pt]' end
    local cells = { row.test == previous and '' or escape(row.test), (escape(row.truth):gsub('A12', '$A_{12}$')) }
    for _, column in ipairs { 'reproduced', 'contradicted', 'reproduced_corrected', 'contradicted_corrected' } do
      cells[#cells + 1] = percent_of(row[column])
    end
    lines[#lines + 1] = row_of(cells)
    previous = row.test
  end
  lines[#lines + 1] = '\\end{longtable}'
  tex.print(lines)
end

-- ---- Tables ----

-- Adds the row of a setting, given its number and the number of settings; a space follows both searches of a combination.
local function add_setting(lines, cells, number, settings)
  lines[#lines + 1] = row_of(cells)
  if number % 2 == 0 and number < settings then lines[#lines + 1] = '\\addlinespace[2pt]' end
end

-- Each setting: its size and its best run.
function tables.print_settings()
  local head = {
    ' & & & & \\multicolumn{2}{c}{best fitness of a run} & \\multicolumn{3}{c}{the best individual} \\\\',
    '\\cmidrule(lr){5-6}\\cmidrule(l){7-9}',
    'setting & runs & gen. & pop. & highest & median & found in gen. & cells & elongation \\\\' }
  local lines = {}
  for number, setting in ipairs(data.settings) do
    local runs, fitness, best = csv.where(data.runs, { setting = setting.setting }), {}, nil
    for _, run in ipairs(runs) do
      fitness[#fitness + 1] = tonumber(run.best_fitness)
      if not best or tonumber(run.best_fitness) > tonumber(best.best_fitness) then best = run end
    end
    best = best or {}
    add_setting(lines, { short(setting.setting), show(setting.runs), show(setting.generations),
      show(setting.population), show(best.best_fitness), show(csv.median(fitness)), show(best.best_generation),
      show(best.best_cells), show(best.elongation) }, number, #data.settings)
  end
  print_tabular('lrrrrrrrr', head, lines)
end

-- The champions of each setting simulated with other steps and engines: changes in per cent.
function tables.print_engines()
  local head = {
    ' & & \\multicolumn{2}{c}{half the step} & \\multicolumn{2}{c}{Bullet} & rank & & \\multicolumn{3}{c}{cause of a difference} \\\\',
    '\\cmidrule(lr){3-4}\\cmidrule(lr){5-6}\\cmidrule(l){9-11}',
    'setting & champions & median & largest & median & largest & corr. & flagged & chaos & step & engine \\\\' }
  local lines = {}
  for number, row in ipairs(data.engines) do
    add_setting(lines, { short(row.setting), show(row.champions), percent_of(row.half_change_median),
      percent_of(row.half_change_largest), percent_of(row.bullet_change_median), percent_of(row.bullet_change_largest),
      tonumber(row.rank_correlation) and ('$%.2f$'):format(tonumber(row.rank_correlation)) or '--',
      show(row.flagged), show(row.cause_chaos), show(row.cause_time_step), show(row.cause_engine) }, number, #data.engines)
  end
  print_tabular('lrrrrrrrrrr', head, lines)
end

-- The fittest champion of each setting in both engines.
function tables.print_witnessed_best()
  local head = {
    ' & & \\multicolumn{4}{c}{displacement} & nudged & \\multicolumn{2}{c}{height at rest} & \\\\',
    '\\cmidrule(lr){3-6}\\cmidrule(lr){8-9}',
    'setting & cells & ours & half & eighth & Bullet & \\% & ours & Bullet & cause \\\\' }
  local lines = {}
  local function length(text) return tonumber(text) and ('%.2f'):format(tonumber(text)) or '--' end
  for number, setting in ipairs(data.settings) do
    local best
    for _, row in ipairs(csv.where(data.witness, { setting = setting.setting })) do
      if not best or tonumber(row.fitness) > tonumber(best.fitness) then best = row end
    end
    if best then
      local land = setting.world == 'terrestrial'
      add_setting(lines, { short(setting.setting), show(best.cells), length(best.displacement),
        length(best.half_displacement), length(best.eighth_displacement), length(best.bullet_displacement),
        ('%.3f'):format(100 * tonumber(best.nudged_change)), land and length(best.rest_height) or '',
        land and length(best.bullet_rest_height) or '', escape(best.cause) }, number, #data.settings)
    end
  end
  print_tabular('lrrrrrrrrl', head, lines)
end

-- The combinations of actuation and world, each with its two searches.
local combinations = { { '^osc%-aq', 'OSC AQ' }, { '^osc%-te', 'OSC TE' }, { '^grn%-aq', 'GRN AQ' }, { '^grn%-te', 'GRN TE' } }

-- The rows of sensitivity by parameter, in order; in each, by column: the combinations halved, then doubled.
local function sensitivity_by_parameter()
  local order, by_name = {}, {}
  for _, row in ipairs(data.sensitivity) do
    local entry = by_name[row.parameter]
    if not entry then
      entry = { name = row.parameter, standard = row.standard }
      by_name[row.parameter], order[#order + 1] = entry, entry
    end
    local first = tonumber(row.value) < tonumber(row.standard) and 0 or #combinations
    for column, combination in ipairs(combinations) do
      if row.setting:find(combination[1]) then
        local cell = entry[first + column] or {}
        entry[first + column], cell[#cell + 1] = cell, row
      end
    end
  end
  return order
end

-- The mean of the searches' median ratios; a dagger if either lost more than a tenth of its viable individuals.
local function sensitivity_cell(rows)
  if not rows then return '' end
  local sum, count, lost = 0, 0, false
  for _, row in ipairs(rows) do
    local ratio = tonumber(row.ratio_median)
    if ratio then sum, count = sum + ratio, count + 1 end
    lost = lost or tonumber(row.viable_after) < 0.9 * tonumber(row.viable_before)
  end
  return (count > 0 and ('%.2f'):format(sum / count) or '--') .. (lost and '\\rlap{$^\\dagger$}' or '')
end

-- The effect of half and twice an assumed value on displacement.
function tables.print_sensitivity()
  local heads = {}
  for _ = 1, 2 do for _, combination in ipairs(combinations) do heads[#heads + 1] = combination[2] end end
  local head = {
    ' & & \\multicolumn{4}{c}{halved} & \\multicolumn{4}{c}{doubled} \\\\', '\\cmidrule(r){3-6}\\cmidrule(l){7-10}',
    'parameter & value & ' .. row_of(heads) }
  local lines = {}
  for _, entry in ipairs(sensitivity_by_parameter()) do
    local cells = { '\\texttt{' .. escape(entry.name) .. '}', typeset.literal(entry.standard) }
    for column = 1, 2 * #combinations do cells[#cells + 1] = sensitivity_cell(entry[column]) end
    lines[#lines + 1] = row_of(cells)
  end
  print_tabular('lr@{\\quad}rrrr@{\\quad}rrrr', head, lines)
end

-- The lowest and the highest number of a column, over the rows of all parameters whose names have this prefix.
function tables.sensitivity_range(prefix, low_column, high_column)
  local low, high
  for _, row in ipairs(data.sensitivity) do
    local least, most = tonumber(row[low_column]), tonumber(row[high_column or low_column])
    if row.parameter:sub(1, #prefix) == prefix and least and most then
      low, high = math.min(low or least, least), math.max(high or most, most)
    end
  end
  return low and ('from %.2f to %.2f'):format(low, high) or 'not known'
end

-- A number of the sample behind that table.
function tables.sensitivity(column) return show(data.sensitivity[1][column]) end

-- The searches of experiments/searches.lua, in the order in which they are shown.
local searches = {
  { 'neat', 'fitness' }, { 'novelty', 'novelty' }, { 'nsga2', 'fitness and novelty (NSGA-II)' },
  { 'nslc', 'novelty, local competition (NSLC)' }, { 'map-elites', 'elites of niches (MAP-Elites)' },
  { 'bodies-first', 'novelty, from diverse bodies' },
}

-- Of a column of these runs (at least one): median, lowest and highest; or the mean.
local function spread(runs, column)
  local values = csv.numbers(runs, column)
  local middle = csv.median(values) -- sorts them
  return ('%.1f (%.1f--%.1f)'):format(middle, values[1], values[#values])
end
local function mean(runs, column, form)
  local sum = 0
  for _, run in ipairs(runs) do sum = sum + tonumber(run[column]) end
  return form:format(sum / #runs)
end

-- Best fitness and diversity of each search, in both worlds.
function tables.print_searches()
  local head = {
    ' & \\multicolumn{3}{c}{in water} & \\multicolumn{3}{c}{on land} \\\\', '\\cmidrule(r){2-4}\\cmidrule(l){5-7}',
    'search & best fitness & shapes & sizes & best fitness & shapes & sizes \\\\' }
  local lines = {}
  for _, search in ipairs(searches) do
    local cells = { search[2] }
    for _, world in ipairs { 'aq-', 'te-' } do
      local runs = csv.where(data.searches, { setting = world .. search[1] })
      cells[#cells + 1] = spread(runs, 'best_fitness')
      cells[#cells + 1] = mean(runs, 'shape_diversity_last', '%.3f')
      cells[#cells + 1] = mean(runs, 'size_entropy', '%.2f')
    end
    lines[#lines + 1] = row_of(cells)
  end
  print_tabular('l@{\\quad}rrr@{\\quad}rrr', head, lines)
end

-- A number that is the same for all runs of that comparison; the number of runs of a setting.
function tables.searched(column) return show(data.searches[1][column]) end
function tables.searched_runs() return show(#csv.where(data.searches, { setting = data.searches[1].setting })) end

-- The outcomes of the individuals in the first and in the last generation.
function tables.print_outcomes()
  local kinds = { 'viable', 'died_out', 'too_small', 'overgrown', 'never_settled', 'exploded', 'overborn' }
  local head = { 'setting & gen. & ' .. row_of(kinds):gsub('_', ' ') }
  local lines = {}
  local previous
  for _, row in ipairs(data.outcomes) do
    local cells = { row.setting == previous and '' or short(row.setting), show(row.generation) }
    if previous and row.setting ~= previous then lines[#lines + 1] = '\\addlinespace[2pt]' end
    for _, kind in ipairs(kinds) do cells[#cells + 1] = ('%.1f'):format(100 * tonumber(row[kind])) end
    lines[#lines + 1] = row_of(cells)
    previous = row.setting
  end
  print_tabular('lr' .. ('r'):rep(#kinds), head, lines)
end

-- Every parameter with its origin and the rules that use it.
function tables.print_parameters()
  local head = 'parameter & value & unit & origin & rules & meaning \\\\'
  local lines = { '\\begin{longtable}{@{}lrl>{\\raggedright}p{1.1cm}>{\\raggedright}p{1.2cm}>{\\raggedright\\arraybackslash}p{5.1cm}@{}}',
    '\\caption{Every parameter of the model. Origin: a section, equation or figure of the original; MN, the configuration of '
    .. 'MultiNEAT that the original used; ours, if no public source gives the value. Rules: those of Appendix~\\ref{app:rules}.}\\label{tab:parameters}\\\\',
    '\\toprule', head, '\\midrule\\endfirsthead', '\\toprule', head, '\\midrule\\endhead', '\\bottomrule\\endfoot' }
  local rules, section = rules_by_parameter(), nil
  for _, row in ipairs(data.parameters) do
    if row.section ~= section then
      section = row.section
      lines[#lines + 1] = ('\\addlinespace\\multicolumn{6}{@{}l}{\\itshape %s}\\\\*\\addlinespace[2pt]'):format(escape(section))
    end
    local value = row.value == '' and 'varies' or typeset.literal(row.value)
    if row.value ~= row.standard and row.value ~= '' then value = ('\\textbf{%s} (%s)'):format(value, typeset.literal(row.standard)) end
    local cited = {}
    for _, rule in ipairs(rules[row.name] or {}) do cited[#cited + 1] = ('\\rul{%s}'):format(rule) end
    lines[#lines + 1] = ('%s & %s & %s & %s & %s & %s \\\\'):format(escape(row.name):gsub('\\_', '\\_\\allowbreak{}'), value,
      escape(row.unit), escape(row.origin), table.concat(cited, ', '), escape(row.meaning))
  end
  lines[#lines + 1] = '\\end{longtable}'
  tex.print(lines)
end

-- Number, title and text of every decision.
function tables.print_decisions()
  local lines = { '\\begin{description}\\setlength\\leftmargin{1em}\\setlength\\itemindent{-1em}\\setlength\\itemsep{2pt}\\setlength\\parsep{0pt}' }
  for _, name in ipairs(decisions()) do
    local text = io.open(decisions_folder .. '/' .. name):read 'a'
    local title = assert(text:match '\n?# (.-)\n', name .. ' has no title')
    local decision = assert(text:match '## Decision\n+(.-)\n\n', name .. ' has no decision')
    local number = name:sub(1, 4)
    lines[#lines + 1] = ('\\item[\\hypertarget{page:%s}{%s}] \\textbf{%s.} %s'):format(number, number, escape(title),
      typeset.marked_up(escape(decision):gsub('\n', ' ')))
  end
  lines[#lines + 1] = '\\end{description}'
  tex.print(lines)
end

return tables
