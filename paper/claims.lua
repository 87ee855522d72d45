-- SPDX-License-Identifier: MIT
-- The claims of the original, from claims.csv: sentences that say what the data show whatever they show, and the table
-- of the claims. A claim has two verdicts: of the runs and generations that there are (reached), and at
-- the size of the original, which is open until the data have it. open() is called first.
local csv = require 'csv'
local typeset = require 'typeset'
local escape, show, short, row_of = typeset.escape, typeset.show, typeset.short, typeset.row_of
local claims = {}
local rows, runs, settings, manifest

function claims.open(folder)
  rows, runs = csv.read(folder .. '/claims.csv'), csv.read(folder .. '/runs.csv')
  settings, manifest = csv.read(folder .. '/settings.csv'), csv.pairs_of(folder .. '/manifest.csv')
end

-- The verdict of the data that there are; open without data.
function claims.reached(row) return row.verdict_reached ~= '' and row.verdict_reached or 'open' end
local reached = claims.reached

-- The rows of claims by name, S11 for all its parts; by 'all' every row. A name that the table lacks is an error.
local function named(ids)
  if ids == 'all' then return rows end
  local list = {}
  for name in ids:gmatch '[^, ]+' do
    local before = #list
    for _, row in ipairs(rows) do
      if row.id == name or row.id:match '^(S%d+)%l?$' == name then list[#list + 1] = row end
    end
    assert(#list > before, 'claims.csv has no claim ' .. name)
  end
  return list
end

-- Words of a list: a, b and c.
local function in_words(list)
  return #list < 2 and (list[1] or '') or table.concat(list, ', ', 1, #list - 1) .. ' and ' .. list[#list]
end

-- The names of claims, parts in a row drawn together: S1, S6a--d and S11c.
function claims.names_of(list)
  local shown, index = {}, 1
  while index <= #list do
    local first, last = list[index].id, index
    local stem, letter = first:match '^(S%d+)(%l)$'
    while stem and list[last + 1] and list[last + 1].id == stem .. string.char(letter:byte() + last - index + 1) do last = last + 1 end
    if last - index >= 2 then
      shown[#shown + 1] = first .. '--' .. list[last].id:sub(-1)
    else
      for at = index, last do shown[#shown + 1] = list[at].id end
    end
    index = last + 1
  end
  return in_words(shown)
end

-- ---- Counts ----

function claims.count() return tostring(#rows) end

-- How many claims have a verdict: of the data that there are, or (of = 'original') at the size of the original.
local function with(verdict, of)
  local list = {}
  for _, row in ipairs(rows) do
    if (of == 'original' and row.verdict or reached(row)) == verdict then list[#list + 1] = row end
  end
  return list
end
function claims.number(verdict, of) return tostring(#with(verdict, of)) end

-- The same without the claims that were used to choose the reading.
function claims.evident(verdict)
  local count = 0
  for _, row in ipairs(with(verdict)) do if row.calibrated ~= '1' then count = count + 1 end end
  return tostring(count)
end

-- How many claims with this verdict the corrected p decides as well.
function claims.corrected(verdict)
  local count = 0
  for _, row in ipairs(with(verdict)) do if row.decided_by:match '_holm$' then count = count + 1 end end
  return tostring(count)
end

-- How many p-values the table has, all of them or those of one column; how many of a difference would be below 5 % by chance.
function claims.tests(column)
  local count = 0
  for _, row in ipairs(rows) do
    for _, name in ipairs(column and { column } or { 'p', 'p_equivalence' }) do if tonumber(row[name]) then count = count + 1 end end
  end
  return tostring(count)
end
function claims.by_chance() return ('%.0f'):format(0.05 * tonumber(claims.tests 'p')) end

-- Whether verdicts at the size of the original need a column: some are open, but not all.
local function has_both() return #with('open', 'original') > 0 and #with('open', 'original') < #rows end

-- The verdicts at the size of the original: all claims are open; or 3 claims are reproduced, …
function claims.at_original()
  if #with('open', 'original') == #rows then return 'all claims are open' end
  local parts = {}
  for index, verdict in ipairs { 'reproduced', 'contradicted', 'inconclusive', 'open' } do
    parts[index] = ('%s %s%s'):format(claims.number(verdict, 'original'), index == 1 and 'claims are ' or '', verdict)
  end
  return in_words(parts)
end

-- ---- Sentences ----

-- The size of the data in words: 3 of 20 runs of each setting, 30 of 2000 generations.
function claims.level()
  local function of(key, unit)
    local there, planned = manifest[key], manifest[key .. '_planned']
    return there == planned and ('%s %s'):format(show(there), unit) or ('%s of %s %s'):format(show(there), show(planned), unit)
  end
  return of('seeds', 'runs of each setting') .. ', ' .. of('generations', 'generations')
end

-- S1 is reproduced; S2 and S3 are inconclusive.
function claims.verdicts(ids)
  local parts = {}
  for _, verdict in ipairs { 'reproduced', 'contradicted', 'inconclusive', 'open' } do
    local list = {}
    for _, row in ipairs(named(ids)) do if reached(row) == verdict then list[#list + 1] = row end end
    if #list > 0 then
      parts[#parts + 1] = ('%s %s %s'):format(claims.names_of(list), #list == 1 and 'is' or 'are', verdict)
    end
  end
  return table.concat(parts, '; ')
end

-- What the claims come to: agrees (some are reproduced, none is contradicted), contradicts, mixed, or undecided.
function claims.outcome(ids)
  local agree, contradict = 0, 0
  for _, row in ipairs(named(ids)) do
    if reached(row) == 'reproduced' then agree = agree + 1 end
    if reached(row) == 'contradicted' then contradict = contradict + 1 end
  end
  if agree > 0 then return contradict > 0 and 'mixed' or 'agrees' end
  return contradict > 0 and 'contradicts' or 'undecided'
end

-- Prints TeX's choice of one of four arguments that follow: for agrees, contradicts, mixed, undecided.
function claims.choose(ids)
  local place = { agrees = 1, contradicts = 2, mixed = 3, undecided = 4 }
  tex.sprint('\\choiceoffour{' .. place[claims.outcome(ids)] .. '}')
end

-- The sides of a comparison by A12, in the direction of the claim; tests not named here expect greater values of a.
local less = { fitness_spread = true, direction = true }
local function in_direction(row)
  local effect = tonumber(row.effect)
  return row.effect_name == 'A12' and effect and (less[row.test] and effect < 0.5 or not less[row.test] and effect > 0.5)
end

-- In how many of these comparisons the data lean to the side of the claim, whatever the test says: 3 of 4.
function claims.leaning(ids)
  local count, total = 0, 0
  for _, row in ipairs(named(ids)) do
    if row.effect_name == 'A12' then
      total = total + 1
      if in_direction(row) then count = count + 1 end
    end
  end
  return ('%d of %d'):format(count, total)
end

local function search_of(setting) return setting:match '%-ns$' and 'novelty search' or 'NEAT' end
local function probability(text, name)
  local value = typeset.probability(text)
  return name .. (value:match '^%$<' and '\\,' or '\\,=\\,') .. value
end

-- A comparison in words: novelty search is ahead in more pairs of runs ($A_{12}$ = 0.62 [0.44, 0.80], p = 0.21; inconclusive).
function claims.comparison(id)
  local row = named(id)[1]
  local effect = tonumber(row.effect)
  if row.effect_name ~= 'A12' or not effect then return 'there are no data yet' end
  local side = effect == 0.5 and 'neither search is ahead in more pairs of runs'
    or search_of(effect > 0.5 and row.setting_a or row.setting_b) .. ' is ahead in more pairs of runs'
  local p = tonumber(row.p) and probability(row.p, '$p$') .. '; ' or ''
  return ('%s ($A_{12}$\\,=\\,%s, %s%s)'):format(side, typeset.interval(row, 'effect'), p, reached(row))
end

-- A count of a claim and its verdict: 0 of 3 runs (inconclusive).
function claims.counted(id)
  local row = named(id)[1]
  if not tonumber(row.effect) then return 'no data' end
  local of = tonumber(row.runs_a) > 0 and row.setting_b == '' and ' of ' .. show(row.runs_a) or ''
  return ('%s%s (%s)'):format(show(row.effect), of, reached(row))
end

-- The generation that a claim is judged at, of the one that it is about: 30 of 2000.
function claims.generation(id)
  local row = named(id)[1]
  if row.at_generation == row.generation then return show(row.generation) end
  return show(row.at_generation) .. ' of ' .. show(row.generation)
end

-- ---- The table ----

-- The two sides of a claim; a common part is given once: OSC AQ, NS : NEAT.
local function sides(row)
  if row.setting_b == '' then return short(row.setting_a) end
  local shared, first = row.setting_a:match '^(.*)%-(%w+)$'
  local second = shared and row.setting_b:match('^' .. shared:gsub('%-', '%%-') .. '%-(%w+)$')
  if second then return ('%s, %s : %s'):format(short(shared), short(first), short(second)) end
  return short(row.setting_a) .. ' : ' .. short(row.setting_b)
end

-- A p-value of a row, its method and its correction: p = 0.012 (exact; Holm 0.25).
local function probability_of(row, column, name, method)
  if not tonumber(row[column]) then return nil end
  return ('%s (%sHolm %s)'):format(probability(row[column], name), method ~= '' and escape(method) .. '; ' or '',
    typeset.probability(row[column .. '_holm']))
end

-- The evidence for a claim: effect, interval and p; then, in small print, the runs and the generation.
local function evidence(row)
  local measured = {}
  if row.effect ~= '' then
    local name = row.effect_name == 'A12' and '$A_{12}$' or escape((row.effect_name:gsub("^a's", "first setting's")))
    measured[1] = ('%s\\,=\\,%s'):format(name, typeset.interval(row, 'effect'))
  end
  measured[#measured + 1] = probability_of(row, 'p', '$p$', row.method)
  measured[#measured + 1] = probability_of(row, 'p_equivalence', 'equivalence: $p$', '')
  local basis = ('%s; %s%s runs'):format(sides(row), show(row.runs_a), row.setting_b ~= '' and ' + ' .. show(row.runs_b) or '')
  if tonumber(row.at_generation) > 0 then basis = basis .. '; gen. ' .. claims.generation(row.id) end
  if row.note_reached ~= '' then basis = basis .. '; ' .. escape(row.note_reached) end
  return ('%s%s{\\scriptsize\\color{quiet}%s}'):format(table.concat(measured, '; '), #measured > 0 and '\\newline ' or '', basis)
end

-- A verdict; with marks if the corrected p does not decide it, and if the claim was used to choose the model. An open one
-- needs none.
function claims.verdict_of(row, verdict)
  if verdict == 'open' then return '\\verdict{open}' end
  local decided = verdict == 'reproduced' or verdict == 'contradicted'
  local marks = (decided and not row.decided_by:match '_holm$' and '*' or '') .. (row.calibrated == '1' and '\\dagger' or '')
  return ('\\verdict{%s}%s'):format(escape(verdict), marks ~= '' and ('\\rlap{$^{%s}$}'):format(marks) or '')
end

-- The median elongation of the champions of a setting.
local function elongation(setting)
  local values = csv.numbers(csv.where(runs, { setting = setting }), 'elongation')
  return #values > 0 and ('%.1f'):format(csv.median(values)) or '--'
end

-- S14, which no test judges: what there is instead, the elongations of both searches in each combination.
local function unjudged()
  local parts = {}
  for _, setting in ipairs(settings) do
    local shared = setting.setting:match '^(.*)%-neat$'
    if shared then parts[#parts + 1] = ('\\mbox{%s %s : %s}'):format(short(shared), elongation(shared .. '-neat'), elongation(shared .. '-ns')) end
  end
  return 'median elongation of the champions, NEAT : NS: ' .. table.concat(parts, ', ')
    .. '\\newline {\\scriptsize\\color{quiet}not a test; Figures~\\ref{fig:swimmers} to \\ref{fig:grnbodies} show the bodies}'
end

-- The headings of the table: the first claim under each.
claims.headings = {
  S1 = 'Best fitness of a generation', S6a = 'Mean best fitness over all generations', S7a = 'Cyclic gaits', S8 = 'The best runs',
  S11a = 'Exploration', S12a = 'Diversity of fitness', S13a = 'Diversity of sizes',
}

local caption = '\\caption{The claims of the original and our results. $A_{12}$: probability that a run of the first setting has a '
  .. 'larger value than a run of the second (one half: no difference), with a bootstrap interval if there are ten runs or more. $p$: test of a '
  .. 'difference, with its method and with Holm\'s correction over all $p$ of the table. Equivalence: $p$ of the test that there is no effect beyond the bound of the claim. '
  .. 'Small print: settings, runs, generation reached of the generation of the claim, and what limits the verdict. '
  .. '%s*: decided by $p$ only without the correction. '
  .. '$\\dagger$: used to choose the reading of the original, so that the verdict is no evidence.}\\label{tab:claims}\\\\'
local two_verdicts = 'Verdict here: from the runs and generations of this copy, as if no more were planned. Original\'s size: with the runs and at the generation of the original; open if this copy lacks them. '
local all_open = 'Verdict: from the runs and generations of this copy, as if no more were planned; at the size of the original all claims are open. '

-- The claims of the original with verdicts; both verdicts if those at the size of the original differ from each other.
function claims.print_claims()
  local both = has_both()
  local verdict_head = both and 'verdict here & original\'s size' or 'verdict'
  local head = ' & claim of the original & its evidence & our results & ' .. verdict_head .. ' \\\\'
  local columns = both and '@{}l>{\\raggedright}p{3.6cm}>{\\raggedright}p{1.6cm}>{\\raggedright}p{5.2cm}l@{\\hskip12pt}l@{}'
    or '@{}l>{\\raggedright}p{4.0cm}>{\\raggedright}p{1.5cm}>{\\raggedright}p{6.8cm}l@{\\hskip8pt}'
  local width = both and 6 or 5
  local note = both and two_verdicts or #with('open', 'original') > 0 and all_open or ''
  local lines = { '\\begin{longtable}{' .. columns .. '}', caption:format(note), '\\toprule', head, '\\midrule\\endfirsthead', '\\toprule', head, '\\midrule\\endhead', '\\bottomrule\\endfoot' }
  local function add(cells, verdicts)
    lines[#lines + 1] = row_of { table.concat(cells, ' & '), table.concat(verdicts, ' & ', 1, both and 2 or 1) }
  end
  for index, row in ipairs(rows) do
    if claims.headings[row.id] then
      lines[#lines + 1] = ('%s\\multicolumn{%d}{@{}l}{\\itshape %s}\\\\*\\addlinespace[1pt]'):format(index > 1 and '\\addlinespace[5pt]' or '', width, claims.headings[row.id])
    else
      lines[#lines + 1] = '\\addlinespace[2pt]'
    end
    add({ escape(row.id), ('%s (%s)'):format(escape(row.statement), escape(row.section)), (escape(row.paper):gsub('^p = ', '$p$\\,=\\,')), evidence(row) },
      { claims.verdict_of(row, reached(row)), claims.verdict_of(row, row.verdict) })
  end
  lines[#lines + 1] = ('\\addlinespace[5pt]\\multicolumn{%d}{@{}l}{\\itshape Shapes}\\\\*\\addlinespace[1pt]'):format(width)
  add({ 'S14', 'The best bodies of both searches look alike (§3.1)', 'Figs. 3--5', unjudged() }, { '\\textcolor{open}{not judged}', '\\textcolor{open}{not judged}' })
  lines[#lines + 1] = '\\end{longtable}'
  tex.print(lines)
end

return claims
