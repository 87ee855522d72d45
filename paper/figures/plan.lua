-- SPDX-License-Identifier: MIT
-- Decides which figures an experiment has, and what each shows, from its tables.
--
--   texlua paper/figures/plan.lua TABLES FRAMES RUNS OUT
--
-- Writes into OUT: design.gp, for series.gp; one <figure>.gp for each figure, which gnuplot draws; bodies.lua, for
-- individuals.lua; and the tables that only figures need, read from the folders of the best runs. Prints the name of each
-- figure, and to the standard error each that is left out, with the reason.
package.path = 'paper/?.lua;paper/figures/?.lua;' .. package.path
local csv = require 'csv'

local tables, frames, runs_folder, out = table.unpack(arg)
local function read(name) return csv.read(tables .. '/' .. name .. '.csv') end

local search_names = { neat = 'NEAT', novelty = 'novelty search', nsga2 = 'NSGA-II', nslc = 'NSLC', ['map-elites'] = 'MAP-Elites' }
local search_colours = { neat = 0x0072B2, novelty = 0xD55E00, nsga2 = 0x009E73, nslc = 0xCC79A7, ['map-elites'] = 0xE69F00 }
local colours = { 0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x882255, 0x117733, 0x999933, 0x666666 }
local actuations = { oscillator = 'oscillators', grn = 'gene network' }
local worlds = { aquatic = 'water', terrestrial = 'land' }

-- ---- Writing ----

-- A text in gnuplot's enhanced mode that shows these characters.
local function plain(text) return (text:gsub('[\\{}^_@&~]', '\\%0'):gsub('[%c]', ' ')) end
-- As a constant of gnuplot.
local function quoted(text) return "'" .. text:gsub("'", "''") .. "'" end

local function save(name, lines)
  local file = assert(io.open(out .. '/' .. name, 'w'))
  file:write(table.concat(lines, '\n'), '\n')
  file:close()
end

local function array(name, values)
  local parts = {}
  for i, value in ipairs(values) do parts[i] = type(value) == 'number' and ('%.10g'):format(value) or quoted(value) end
  return ('array %s[%d] = [%s]'):format(name, #values, table.concat(parts, ', '))
end

local function left_out(figure, reason) io.stderr:write('left out: ', figure, ': ', reason, '\n') end

-- The figure that this script of paper/figures draws, after some lines.
local function figure(name, script, ...)
  local lines = { ... }
  table.insert(lines, 1, 'design = ' .. quoted(out .. '/design.gp'))
  table.insert(lines, ("load 'paper/figures/%s.gp'"):format(script))
  save(name .. '.gp', lines)
  print(name)
end

-- ---- Settings, their panels and series ----

local settings = read 'settings'
for number, row in ipairs(settings) do
  row.number = number
  row.search_name = search_names[row.search] or row.search
  row.panel = actuations[row.actuation] .. ', ' .. worlds[row.world]
end

local panels, members = {}, {}
for _, row in ipairs(settings) do
  if not members[row.panel] then
    members[row.panel] = {}
    table.insert(panels, row.panel)
  end
  table.insert(members[row.panel], row)
end

-- Whether all rows have the same value of a column.
local function is_same(rows, column)
  for _, row in ipairs(rows) do if row[column] ~= rows[1][column] then return false end end
  return true
end

local function all_differ(rows, column)
  local seen = {}
  for _, row in ipairs(rows) do
    if seen[row[column]] then return false end
    seen[row[column]] = true
  end
  return true
end

-- What the titles of a panel do not have in common at their beginning, by whole words.
local function own_parts(rows)
  local common = rows[1].title
  for _, row in ipairs(rows) do
    local length = 0
    while length < #common and common:byte(length + 1) == row.title:byte(length + 1) do length = length + 1 end
    common = common:sub(1, length)
  end
  common = #rows > 1 and common:match '^.*[%s:,]' or ''
  for _, row in ipairs(rows) do row.label = row.title:sub(#common + 1):match '^%s*(.-)%s*$' end
  for _, row in ipairs(rows) do if row.label == '' then row.label = row.title end end
end

local one_search = is_same(settings, 'search')
local by_search = #settings > 1 and not one_search
for _, panel in ipairs(panels) do by_search = by_search and all_differ(members[panel], 'search') end
for _, panel in ipairs(panels) do
  if not by_search then own_parts(members[panel]) end
  for _, row in ipairs(members[panel]) do
    if by_search then row.label = row.search_name elseif not one_search or #settings == 1 then row.label = row.label .. ' (' .. row.search_name .. ')' end
  end
end

local series, hues, number_of = {}, {}, {}
for _, row in ipairs(settings) do
  if not number_of[row.label] then
    table.insert(series, row.label)
    number_of[row.label] = #series
    table.insert(hues, by_search and search_colours[row.search] or colours[(#series - 1) % #colours + 1])
  end
end

local function title_of_panel(panel)
  local text = panel
  if one_search then text = text .. ', ' .. settings[1].search_name end
  if #settings == 1 then text = settings[1].title .. ': ' .. text end
  return text
end

local function column_of(rows, column, change)
  local values = {}
  for i, row in ipairs(rows) do values[i] = (change or function(text) return text end)(row[column]) end
  return values
end

-- ---- What the folders of the best runs hold ----

local best = {} -- the rows of runs.csv
for _, row in ipairs(read 'runs') do
  local other = best[row.setting]
  if not other or tonumber(row.best_fitness) > tonumber(other.best_fitness) then best[row.setting] = row end
end

local function folder_of(setting) return ('%s/%s/seed-%03d'):format(runs_folder, setting, tonumber(best[setting].seed)) end

-- Calls visit(row) for each row of a packed table of the setting's best run, up to its generations. No field has a comma.
local function each_packed(row, name, visit)
  local pipe = assert(io.popen("gzip -cd '" .. (folder_of(row.setting) .. '/' .. name):gsub("'", "'\\''") .. "'"))
  local header = {}
  for text in (pipe:read 'l' or ''):gmatch '[^,]+' do header[#header + 1] = text end
  for line in pipe:lines() do
    local fields, at = {}, 0
    for text in (line .. ','):gmatch '([^,]*),' do
      at = at + 1
      fields[header[at] or at] = text
    end
    if tonumber(fields.generation) < tonumber(row.generations) then visit(fields, header) end
  end
  pipe:close()
end

local function identity_of(row)
  local map = {}
  for _, item in ipairs(csv.read(folder_of(row.setting) .. '/identity.csv')) do map[item.key] = item end
  return map
end

-- Whether a function of the setting is the paper's own.
local function is_of_paper(row, name)
  local item = identity_of(row)['function ' .. name]
  return item ~= nil and item.place:find('^paper/judgement%.lua:') ~= nil
end

-- The paper's fitness is a distance; what another one measures is not known.
local fitness = 'best fitness (cell diameters)'
for _, row in ipairs(settings) do if not is_of_paper(row, 'fitness') then fitness = 'best fitness' end end
do
  local titles, lists, numbers, names = {}, {}, {}, {}
  for i, panel in ipairs(panels) do
    titles[i] = plain(title_of_panel(panel))
    lists[i] = table.concat(column_of(members[panel], 'number'), ' ')
  end
  for i, row in ipairs(settings) do numbers[i] = number_of[row.label] end
  for i, text in ipairs(series) do names[i] = plain(text) end
  save('design.gp', { array('setting', column_of(settings, 'setting')), array('series_of', numbers), array('series', names), array('hue', hues),
                      array('panel', titles), array('members', lists), 'fitness_label = ' .. quoted(fitness) })
end

-- ---- Which figures there are ----

local function numbers_of(rows) return table.concat(column_of(rows, 'number'), ' ') end
local function having(name, wanted)
  local there, chosen = {}, {}
  for _, row in ipairs(read(name)) do there[row.setting] = true end
  for _, row in ipairs(settings) do if there[row.setting] and wanted(row) then chosen[#chosen + 1] = row end end
  return chosen
end

local all = {}
for i = 1, #panels do all[i] = i end
figure('performance', 'performance', ("panels = '%s'"):format(table.concat(all, ' ')))
figure('final', 'runs', "measure = 'best_fitness'", "means = ''", 'axis = ' .. quoted(fitness))
figure('cells', 'runs', "measure = 'best_cells'", "means = ''", "axis = 'cells of the best individual'")
figure('size_entropy', 'runs', "measure = 'size_entropy'", "means = 'entropy'", "axis = 'entropy of body sizes (nats)'")

local swimmers = having('endpoints', function(row) return row.world == 'aquatic' end)
if #swimmers == 0 then left_out('exploration', 'every setting has ground') else
  local shown, roles = {}, {}
  for _, row in ipairs(swimmers) do
    for _, role in ipairs(#swimmers <= 2 and tonumber(row.runs) > 1 and { 'best', 'median' } or { 'best' }) do
      shown[#shown + 1], roles[#roles + 1] = row.number, role
    end
  end
  figure('exploration', 'exploration', ("shown = '%s'"):format(table.concat(shown, ' ')), ("roles = '%s'"):format(table.concat(roles, ' ')))
end

local walkers = having('endpoint_density', function(row) return row.world == 'terrestrial' end)
if #walkers == 0 then left_out('walkers', 'no setting has ground') else figure('walkers', 'walkers', ("shown = '%s'"):format(numbers_of(walkers))) end

-- The lines of a setting's world, of its best individual; nothing in open water and on flat ground.
local lines_of = {}
for _, row in ipairs(csv.read(frames .. '/frame_terrain.csv')) do
  if row.rank == '1' then
    local lines = lines_of[row.setting] or {}
    lines_of[row.setting] = lines
    table.insert(lines, { kind = row.kind, line = row.kind .. row.line, x = tonumber(row.x), y = tonumber(row.y) })
  end
end
local function is_shaped(lines)
  for _, point in ipairs(lines or {}) do if point.kind ~= 'ground' or point.y ~= 0 then return true end end
  return false
end

local most_points = 5000
local near = 12 -- cells
local shaped = {}
for _, row in ipairs(settings) do if is_shaped(lines_of[row.setting]) then shaped[#shaped + 1] = row end end
if #shaped == 0 then left_out('world', 'no world has hills or obstacles') else
  local points, lines = { 'setting,generation,x,y' }, { 'setting,x,y' }
  local ends = { left = {}, right = {}, low = {}, high = {} }
  for n, row in ipairs(shaped) do
    local left, right, low, high = 0, 0, 0, 0
    local chosen = {}
    each_packed(row, 'individuals.csv.gz', function(one)
      if one.outcome ~= 'viable' then return end
      local x, y = tonumber(one.finish_x), tonumber(one.finish_y)
      left, right, low, high = math.min(left, x), math.max(right, x), math.min(low, y), math.max(high, y)
      chosen[#chosen + 1] = ('%s,%s,%.4f,%.4f'):format(row.setting, one.generation, x, y)
    end)
    for i = 1, #chosen, math.ceil(#chosen / most_points) do points[#points + 1] = chosen[i] end
    for _, point in ipairs(lines_of[row.setting]) do -- what stands near belongs to the picture
      if point.kind == 'obstacle' and point.x > left - near and point.x < right + near then
        left, right = math.min(left, point.x), math.max(right, point.x)
      end
    end
    local before
    for _, point in ipairs(lines_of[row.setting]) do
      if before and before ~= point.line then lines[#lines + 1] = '' end
      before = point.line
      lines[#lines + 1] = ('%s,%.4f,%.4f'):format(row.setting, point.x, point.y)
      if point.x > left and point.x < right then low, high = math.min(low, point.y), math.max(high, math.min(point.y, high + 3)) end
    end
    lines[#lines + 1] = ''
    local margin = math.max(4, 0.04 * (right - left))
    ends.left[n], ends.right[n], ends.low[n], ends.high[n] = left - margin, right + margin, low - 1.5, high + 3
  end
  save('world_points.csv', points)
  save('world_lines.csv', lines)
  figure('world', 'world', ("shown = '%s'"):format(numbers_of(shaped)), 'extra = ' .. quoted(out), array('left', ends.left),
         array('right', ends.right), array('low', ends.low), array('high', ends.high))
end

local archives = having('archives', function(row) return row.search ~= 'map-elites' end)
if #archives == 0 then left_out('archive', 'no search of these keeps an archive of novelty') else
  local rank = { plane = 1, numbers = 2, line = 3 }
  for _, row in ipairs(archives) do
    row.kind = not is_of_paper(row, 'behaviour') and 'numbers' or row.world == 'terrestrial' and 'line' or 'plane'
  end
  table.sort(archives, function(a, b)
    if a.kind ~= b.kind then return rank[a.kind] < rank[b.kind] end
    return a.number < b.number
  end)
  local kinds = column_of(archives, 'kind')
  figure('archive', 'archive', ("shown = '%s'"):format(numbers_of(archives)), ("kinds = '%s'"):format(table.concat(kinds, ' ')))
end

-- The niches of a number of the descriptor: its name, and the ends of that of a value.
local function niches(identity, index, name)
  local stated = (identity['descriptor ' .. index] or {}).value or ''
  local from, to, count = stated:match ' (%S+) to (%S+) in (%d+)$'
  local width = tonumber((identity['parameter niche_width'] or {}).value) or 1
  if from then width = (to - from) / count end
  local first = tonumber(from) or 0
  return { name = name:gsub('^behaviour_', ''):gsub('_', ' '), ends = function(value)
    local at = math.floor((value - first) / width)
    if count then at = math.max(0, math.min(count - 1, at)) end
    return first + at * width, first + (at + 1) * width
  end }
end

local mapped = having('archives', function(row) return row.search == 'map-elites' end)
if #mapped == 0 then left_out('map', 'no search is MAP-Elites') else
  local lines, first, second = { 'setting,x_low,x_high,y_low,y_high,fitness' }, {}, {}
  for n, row in ipairs(mapped) do
    local identity, of_x, of_y = identity_of(row)
    local elites, order = {}, {}
    each_packed(row, 'archive.csv.gz', function(one, header)
      if not of_x then of_x, of_y = niches(identity, 1, header[5]), niches(identity, 2, header[6] or header[5]) end
      local x1, x2 = of_x.ends(tonumber(one[header[5]]))
      local y1, y2 = of_y.ends(tonumber(one[header[6] or header[5]]))
      local key = ('%s,%.6g,%.6g,%.6g,%.6g'):format(row.setting, x1, x2, y1, y2)
      if not elites[key] then order[#order + 1] = key end
      elites[key] = math.max(elites[key] or -math.huge, tonumber(one.fitness))
    end)
    for _, key in ipairs(order) do lines[#lines + 1] = ('%s,%.10g'):format(key, elites[key]) end
    local function axis(of, words) return of and (of.name == 'x' or of.name == 'y') and words or plain(of and of.name or words) end
    first[n], second[n] = axis(of_x, 'first number of the descriptor'), axis(of_y, 'second number of the descriptor')
  end
  save('elites.csv', lines)
  figure('map', 'map', ("shown = '%s'"):format(numbers_of(mapped)), 'extra = ' .. quoted(out), array('first', first), array('second', second))
end

figure('distribution', 'distribution')
if tonumber(settings[1].generations) > 1 then figure('heredity', 'heredity') else left_out('heredity', 'there is one generation') end

-- Texts of a page go through a table, where gnuplot takes a quotation mark for the begin of a field and reads escapes twice.
local bodies = { 'return {' }
for _, row in ipairs(settings) do
  local title = #settings == 1 and row.title .. ' (' .. row.search_name .. ')' or row.label .. (#panels > 1 and ': ' .. row.panel or '')
  bodies[#bodies + 1] = ('  { setting = %q, title = %q },'):format(row.setting, (title:gsub('"', '”'):gsub('%c', ' '):gsub('\\', ('\\'):rep(4))))
end
bodies[#bodies + 1] = '}'
save('bodies.lua', bodies)
if #csv.read(frames .. '/morphologies.csv') == 0 then left_out('bodies', 'no run has a viable individual') else print 'bodies' end
