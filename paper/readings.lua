-- SPDX-License-Identifier: MIT
-- The numbers and tables of the section on readings, from readings.csv and readings_heredity.csv: the readings of
-- experiments/readings.lua, and the size of their data. open() is called first.
local csv = require 'csv'
local typeset = require 'typeset'
local row_of, print_tabular = typeset.row_of, typeset.print_tabular
local readings = {}
local runs, heredity

-- In the order of the tables, in groups: the name in the script; the name in the tables; what differs from the standard;
-- the same in words; the decisions; and a part of the names of its settings if it concerns only some settings.
local groups = {
  { { 'standard', '\\textbf{standard}', nil, 'neither cell takes the direction of a division; an orientation turns with the tissue; division angles up to '
      .. '\\parameter{division_angle_range} half turns; weights of generation 0 up to \\parameter{start_weight}, weight mutations up to \\parameter{weight_power}', '0002, 0013' },
    { 'earlier', 'earlier standard', 'five of those below', 'the standard of this replication before heredity was measured: '
      .. 'combines both turn, plane, range 1, start weights 1 and mutations 1', '0020' } },
  { { 'both-turn', 'both turn', 'division_turn = both', 'mother and daughter take the direction of the division', '0002' },
    { 'daughters', 'daughter turns', 'division_turn = daughter', 'only the daughter takes it', '0002' },
    { 'plane', 'plane', 'orientation_frame = plane', 'an orientation keeps its direction in the plane, however the tissue turns', '0002' },
    { 'range-1', 'range 1', 'division_angle_range = 1', 'division angles up to 1 half turn', '0002' },
    { 'range-025', 'range 0.25', 'division_angle_range = 0.25', 'division angles up to 0.25 half turns', '0002' },
    { 'clearance', 'clearance 0.75', 'division_clearance = 0.75', 'a daughter must have this distance to other cells, instead of \\parameter{division_clearance}', '0002' } },
  { { 'start-1', 'start weights 1', 'start_weight = 1', 'weights of generation 0 up to 1', '0013' },
    { 'power-1', 'mutations 1', 'weight_power = 1', 'weight mutations up to 1', '0013' } },
  { { 'rising', 'time rises', 'gait_time = rising', 'the time input keeps rising during locomotion (GRN only)', '0012', 'grn' },
    { 'present', 'present place', 'gait_place = present', 'during locomotion, networks read the present place of their cell (GRN only)', '0012', 'grn' },
    { 'aged', 'aged species', 'novelty_species = aged', 'novelty search keeps the factors of young and stagnating species (NS only)', '0014', '-ns' } },
}
local combinations = { 'osc-aq', 'osc-te', 'grn-aq', 'grn-te' }
local dash, blank_pair = '--', '\\multicolumn{2}{c}{}'

-- Reads both tables; a reading that is in the tables but not in the list above is an error.
function readings.open(folder)
  runs, heredity = csv.read(folder .. '/readings.csv'), csv.read(folder .. '/readings_heredity.csv')
  for _, row in ipairs(runs) do
    local known = false
    for _, group in ipairs(groups) do
      for _, reading in ipairs(group) do
        known = known or row.setting:match '^(.*)%-%w+%-%w+%-%w+$' == reading[1]
      end
    end
    assert(known, 'readings.csv has a reading that paper/readings.lua does not list: ' .. row.setting)
  end
end

-- The result of a function by its name, with an argument between quotes if it takes one: leaning('fitness').
function readings.call(text)
  local name, argument = text:match "^([%w_]+)%('?([%w_]*)'?%)$"
  return readings[name or text](argument)
end

-- ---- Size of the data ----

-- How many readings have runs.
function readings.number()
  local seen, count = {}, 0
  for _, row in ipairs(runs) do
    local name = row.setting:match '^(.*)%-%w+%-%w+%-%w+$'
    if not seen[name] then seen[name], count = true, count + 1 end
  end
  return tostring(count)
end
function readings.generations() return typeset.show(runs[1].generations) end

-- The number of runs of the settings: one number, or the lowest and the highest.
function readings.runs()
  local count, low, high = {}, math.huge, 0
  for _, row in ipairs(runs) do count[row.setting] = (count[row.setting] or 0) + 1 end
  for _, number in pairs(count) do low, high = math.min(low, number), math.max(high, number) end
  return (low == high and tostring(low) or low .. ' to ' .. high) .. (high == 1 and ' run' or ' runs')
end

-- The generations of the table of heredity, counted from 0: all, or only those in the second half of the runs.
local function recorded(late)
  local seen, list = {}, {}
  for _, row in ipairs(heredity) do
    local generation = tonumber(row.generation)
    if not seen[generation] and (not late or 2 * generation >= tonumber(runs[1].generations)) then
      seen[generation], list[#list + 1] = true, generation
    end
  end
  table.sort(list)
  return list
end

-- A list in words: 39, 49 and 59.
local function in_words(list)
  return #list < 2 and tostring(list[1]) or table.concat(list, ', ', 1, #list - 1) .. ' and ' .. list[#list]
end
function readings.late_generations() return (#recorded(true) > 1 and 'generations ' or 'generation ') .. in_words(recorded(true)) end
function readings.first_generation() return tostring(recorded()[1]) end
function readings.last_generation() return tostring(recorded()[#recorded()]) end

-- Why a cell is empty.
function readings.why_empty()
  for _, group in ipairs(groups) do
    for _, reading in ipairs(group) do
      for _, combination in ipairs(combinations) do
        for _, search in ipairs { '-neat', '-ns' } do
          local setting = combination .. search
          local concerned = not reading[6] or setting:find(reading[6], 1, true)
          if concerned and #csv.where(runs, { setting = reading[1] .. '-' .. setting }) == 0 then
            return 'the reading does not concern the setting, or its runs are missing'
          end
        end
      end
    end
  end
  return 'the reading does not concern the setting'
end

-- ---- Cells ----

-- The rows of a reading in a combination; of one search, or of both.
local function of(rows, reading, combination, search)
  local chosen = {}
  for _, name in ipairs(search and { search } or { 'neat', 'ns' }) do
    local found = csv.where(rows, { setting = reading .. '-' .. combination .. '-' .. name })
    table.move(found, 1, #found, #chosen + 1, chosen)
  end
  return chosen
end

-- Whether the data have runs of a reading in this combination and search.
local function is_there(...) return #of(runs, ...) > 0 end

local function decimal(value) return value == '' and dash or (('%.2f'):format(value):gsub('^%-', '$-$')) end
local function percent(value, form) return tonumber(value) and (form or '%.0f'):format(100 * tonumber(value)) or dash end

-- The median of a measure of heredity under NEAT over the late recorded generations.
local function late_median(reading, combination, column)
  local values = {}
  for _, generation in ipairs(recorded(true)) do
    for _, row in ipairs(of(heredity, reading, combination, 'neat')) do
      if tonumber(row.generation) == generation then values[#values + 1] = tonumber(row[column]) end
    end
  end
  return csv.median(values)
end

local function heredity_cells(reading, combination)
  if not is_there(reading, combination, 'neat') then return { '', '', '' } end
  return { decimal(late_median(reading, combination, 'heredity_fitness')), percent(late_median(reading, combination, 'near_mother')),
    percent(late_median(reading, combination, 'near_best'), '%.1f') }
end

-- The share of cyclic gaits in the first and in the last recorded generation, two columns.
local function cyclic_cell(reading, combination, search)
  if not is_there(reading, combination, search) then return blank_pair end
  local rows = of(heredity, reading, combination, search)
  local function at(generation) return percent((csv.where(rows, { generation = generation })[1] or {}).cyclic) end
  return at(readings.first_generation()) .. ' & ' .. at(readings.last_generation())
end

-- The fewest and the most cells of the best individual of a run, over both searches.
local function size_cell(reading, combination)
  local cells = csv.numbers(of(runs, reading, combination), 'best_cells')
  table.sort(cells)
  return #cells == 0 and '' or ('%d--%d'):format(cells[1], cells[#cells])
end

-- The median best fitness of each search, and the number of seeds in which novelty search has the higher best fitness.
local function outcome_cells(reading, combination)
  local neat, ns = of(runs, reading, combination, 'neat'), of(runs, reading, combination, 'ns')
  local function middle(rows) return #rows > 0 and ('%.1f'):format(csv.median(csv.numbers(rows, 'best_fitness'))) or '' end
  local pairs_there, ahead = 0, 0
  for _, row in ipairs(ns) do
    for _, other in ipairs(csv.where(neat, { seed = row.seed })) do
      pairs_there = pairs_there + 1
      if tonumber(row.best_fitness) > tonumber(other.best_fitness) then ahead = ahead + 1 end
    end
  end
  return { middle(neat), middle(ns), pairs_there > 0 and ('%d/%d'):format(ahead, pairs_there) or '' }
end

-- ---- Conclusions ----

-- What the original concludes of the two searches, as columns of runs.csv in which it expects higher (1) or lower (-1)
-- values with novelty search.
local conclusions = {
  fitness = { '*', 'best_fitness', 1 },
  exploration = { 'aq', 'direction_resultant', -1, 'te', 'side_switches', 1 },
  spread = { '*', 'fitness_spread_last', 1 },
  sizes = { '*', 'size_entropy', 1 },
}
local shown = { 'fitness', 'exploration', 'spread', 'sizes' }

-- Whether a reading concerns novelty search alone.
local function is_of_novelty(name)
  for _, group in ipairs(groups) do
    for _, reading in ipairs(group) do if reading[1] == name then return reading[6] == '-ns' end end
  end
end

-- How often a run of novelty search exceeds one of NEAT in the sense of a conclusion: 1 in every pair, 0 in none; no
-- number without runs. A reading that concerns novelty search alone is compared with the standard's runs of NEAT.
local function agreement(name, reading, combination)
  local measure = conclusions[name]
  local at = (measure[1] == '*' or combination:find(measure[1], 1, true)) and 1 or 4
  local neat = of(runs, is_of_novelty(reading) and 'standard' or reading, combination, 'neat')
  local a, b = csv.numbers(of(runs, reading, combination, 'ns'), measure[at + 1]), csv.numbers(neat, measure[at + 1])
  if #a == 0 or #b == 0 then return nil end
  local sum = 0
  for _, x in ipairs(a) do
    for _, y in ipairs(b) do sum = sum + (x == y and 0.5 or (x - y) * measure[at + 2] > 0 and 1 or 0) end
  end
  return sum / (#a * #b)
end

-- Calls `with` for each reading and combination that has an agreement.
local function each_agreement(name, with)
  for _, group in ipairs(groups) do
    for _, reading in ipairs(group) do
      for _, combination in ipairs(combinations) do
        local value = agreement(name, reading[1], combination)
        if value then with(value, reading[1], combination) end
      end
    end
  end
end

-- In how many comparisons most pairs of runs agree with a conclusion: 31 of 46. In how many all do, or none.
function readings.leaning(name)
  local agree, total = 0, 0
  each_agreement(name, function(value) total = total + 1; if value > 0.5 then agree = agree + 1 end end)
  return ('%d of %d'):format(agree, total)
end
function readings.separated(name)
  local all, none = 0, 0
  each_agreement(name, function(value) all, none = all + (value == 1 and 1 or 0), none + (value == 0 and 1 or 0) end)
  return ('all pairs agree in %d and none in %d'):format(all, none)
end

-- The readings under which most pairs agree with a conclusion in no combination; none: no reading.
function readings.against(name)
  local best, order = {}, {}
  each_agreement(name, function(value, reading)
    if not best[reading] then order[#order + 1] = reading end
    best[reading] = math.max(best[reading] or 0, value)
  end)
  local list = {}
  for _, group in ipairs(groups) do
    for _, reading in ipairs(group) do
      if best[reading[1]] and best[reading[1]] <= 0.5 then list[#list + 1] = reading[2] end
    end
  end
  return #list == 0 and 'none' or in_words(list)
end

-- The smallest p of a rank-sum test of so few runs.
function readings.least_p()
  local count = #csv.where(runs, { setting = runs[1].setting })
  return typeset.probability(tables.least_p(count, count))
end

-- An agreement as a cell: Cliff's delta, the share of pairs that agree minus that of the others, with its sign; bold if it
-- is all or none.
local function agreement_cell(name, reading, combination)
  local value = agreement(name, reading, combination)
  if not value then return '' end
  if value == 0.5 then return '0' end
  local delta = ('%.2f'):format(math.abs(2 * value - 1)):gsub('^0', ''):gsub('^1.00$', '1')
  local text = (value > 0.5 and '+' or '-') .. delta
  return (value == 0 or value == 1) and ('$\\mathbf{%s}$'):format(text) or ('$%s$'):format(text)
end

-- ---- Tables ----

-- Whether any cell has content.
local function has_content(cells)
  for _, cell in ipairs(cells) do if cell ~= '' and cell ~= blank_pair then return true end end
  return false
end

-- A row for each reading of which cells_of gives at least one cell with content; a little space between groups.
local function lines_of(cells_of)
  local lines = {}
  for _, group in ipairs(groups) do
    local before = #lines
    for _, reading in ipairs(group) do
      local cells = cells_of(reading[1])
      if has_content(cells) then
        if #lines == before and before > 0 then lines[#lines + 1] = '\\addlinespace[3pt]'; before = #lines end
        lines[#lines + 1] = row_of { reading[2], table.unpack(cells) }
      end
    end
  end
  return lines
end

-- The cells of all four combinations, one after the other.
local function in_all(cells_of)
  return function(reading)
    local cells = {}
    for _, combination in ipairs(combinations) do
      for _, cell in ipairs(cells_of(reading, combination)) do cells[#cells + 1] = cell end
    end
    return cells
  end
end

local names = { 'OSC AQ', 'OSC TE', 'GRN AQ', 'GRN TE' }
-- Two lines of a head: each combination over so many columns from column 2 on.
local function heads(columns)
  local first, rules = {}, {}
  for index, name in ipairs(names) do
    local from = 2 + (index - 1) * columns
    first[index] = ('\\multicolumn{%d}{c}{%s}'):format(columns, name)
    rules[index] = ('\\cmidrule(l{6pt}){%d-%d}'):format(from, from + columns - 1)
  end
  return ' & ' .. row_of(first), table.concat(rules)
end

-- The list of readings.
function readings.print_list()
  local lines = {}
  for index, group in ipairs(groups) do
    if index > 1 then lines[#lines + 1] = '\\addlinespace[3pt]' end
    for _, reading in ipairs(group) do
      local name, value = (reading[3] or ''):match '^([%w_]+) = (%S+)$'
      lines[#lines + 1] = row_of { reading[2],
        name and ('\\texttt{%s}: \\texttt{%s}'):format(typeset.escape(name), value) or reading[3] or '', reading[4], tables.origin(reading[5]) }
    end
  end
  print_tabular('@{}l>{\\raggedright}p{3.9cm}>{\\raggedright}p{6.9cm}l@{}', { 'reading & differs in & in words & decision \\\\' }, lines)
end

-- Rule 2 of the choice.
function readings.print_heredity()
  local first, rules = heads(3)
  print_tabular('l' .. ('@{\\hskip18pt}rrr'):rep(4), { first, rules, 'reading' .. (' & $\\rho$ & $m$ & $b$'):rep(4) .. ' \\\\' },
    lines_of(in_all(heredity_cells)))
end

-- Rules 3 and 4.
function readings.print_bodies()
  local head = {
    ' & \\multicolumn{8}{c}{cyclic gaits, \\%} & \\multicolumn{4}{c}{cells of the best} \\\\', '\\cmidrule(lr){2-9}\\cmidrule(l){10-13}',
    ' & \\multicolumn{4}{c}{GRN AQ} & \\multicolumn{4}{c}{GRN TE} \\\\', '\\cmidrule(lr){2-5}\\cmidrule(lr){6-9}',
    'reading' .. (' & \\multicolumn{2}{c}{NEAT} & \\multicolumn{2}{c}{NS}'):rep(2) .. ' & ' .. row_of(names) }
  print_tabular('l' .. ('r@{\\,/\\,}l'):rep(4) .. 'rrrr', head, lines_of(function(reading)
    local cells = {}
    for _, combination in ipairs { 'grn-aq', 'grn-te' } do
      for _, search in ipairs { 'neat', 'ns' } do cells[#cells + 1] = cyclic_cell(reading, combination, search) end
    end
    for _, combination in ipairs(combinations) do cells[#cells + 1] = size_cell(reading, combination) end
    return cells
  end))
end

-- The results that were not considered in the choice.
function readings.print_outcome()
  local first, rules = heads(3)
  print_tabular('l' .. ('@{\\hskip13pt}rrr'):rep(4), { first, rules, 'reading' .. (' & NEAT & NS & ahead'):rep(4) .. ' \\\\' },
    lines_of(in_all(outcome_cells)))
end

-- Which conclusions of the original hold under which reading.
function readings.print_conclusions()
  local titles = { 'best fitness (S1--S6)', 'exploration (S11)', 'fitness spread (S12)', 'size entropy (S13)' }
  local first, rules, second = {}, {}, {}
  for index, title in ipairs(titles) do
    first[index] = ('\\multicolumn{4}{c}{%s}'):format(title)
    rules[index] = ('\\cmidrule(l{6pt}){%d-%d}'):format(4 * index - 2, 4 * index + 1)
  end
  for _ = 1, 2 do for _, actuation in ipairs { 'OSC', 'GRN' } do second[#second + 1] = ('\\multicolumn{2}{c}{%s}'):format(actuation) end end
  for index = 5, 8 do second[index] = second[index - 4] end
  local function cells(reading)
    local list = {}
    for _, name in ipairs(shown) do
      for _, combination in ipairs(combinations) do list[#list + 1] = agreement_cell(name, reading, combination) end
    end
    return list
  end
  print_tabular('@{}l' .. ('@{\\hskip10pt}rrrr'):rep(4) .. '@{}', { ' & ' .. row_of(first), table.concat(rules), ' & ' .. row_of(second),
    'reading' .. (' & AQ & TE'):rep(8) .. ' \\\\' }, lines_of(cells))
end

return readings
