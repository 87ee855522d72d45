-- SPDX-License-Identifier: MIT
-- The claims of the original under other readings, from robustness.csv: the rows of claims.csv for each reading, at the
-- same number of generations. open() is called first, after that of claims.
local csv = require 'csv'
local typeset = require 'typeset'
local claims = require 'claims'
local robustness = {}
local readings, of_reading

-- The names of paper/readings.lua; a reading that is not listed is named by its parameter.
local titles = { standard = '\\textbf{standard}', ['division_angle_range=0.25'] = 'range 0.25', ['weight_power=1'] = 'mutations 1' }

-- Reads the table: the readings in the order of the file, and the claims of each in one order.
function robustness.open(folder)
  readings, of_reading = {}, {}
  for _, row in ipairs(csv.read(folder .. '/robustness.csv')) do
    if not of_reading[row.reading] then
      readings[#readings + 1], of_reading[row.reading] = row.reading, {}
    end
    table.insert(of_reading[row.reading], row)
  end
  for _, reading in ipairs(readings) do
    assert(#of_reading[reading] == #of_reading[readings[1]], 'robustness.csv has other claims for ' .. reading)
  end
end

-- ---- Size of the data ----

function robustness.number() return tostring(#readings) end

-- The largest value of a column: the runs of a setting, the generations.
local function largest(column)
  local most = 0
  for _, row in ipairs(of_reading[readings[1]]) do most = math.max(most, tonumber(row[column]) or 0) end
  return typeset.show(most)
end
function robustness.runs() return largest 'runs_a' end
function robustness.generations() return largest 'at_generation' end

-- ---- Sentences ----

-- The verdicts of a claim, by its place in the table, under all readings: a set of texts, and how many there are.
local function verdicts_at(place)
  local set, count = {}, 0
  for _, reading in ipairs(readings) do
    local verdict = claims.reached(of_reading[reading][place])
    if not set[verdict] then set[verdict], count = true, count + 1 end
  end
  return set, count
end

-- The claims for which `fits` is true of their verdicts; none: no claim.
local function which(fits)
  local list = {}
  for place, row in ipairs(of_reading[readings[1]]) do
    if fits(verdicts_at(place)) then list[#list + 1] = row end
  end
  return #list > 0 and claims.names_of(list) or 'no claim', #list
end

-- The claims with this verdict under every reading, with their verb: S1 and S6a are.
function robustness.always(verdict)
  local text, count = which(function(set, different) return different == 1 and set[verdict] end)
  return text .. (count > 1 and ' are' or ' is')
end

-- The claims that are decided under some readings and not under others, and never against each other.
function robustness.sometimes(verdict)
  return (which(function(set, count)
    return count > 1 and set[verdict] and not (set.reproduced and set.contradicted)
  end))
end

-- The claims that one reading reproduces and another contradicts.
function robustness.opposite()
  return (which(function(set) return set.reproduced and set.contradicted end))
end

-- In how many of the comparisons of two searches all readings have the same search ahead: 12 of 18.
function robustness.shared_directions()
  local shared, total = 0, 0
  for place, first in ipairs(of_reading[readings[1]]) do
    local up, down, known = 0, 0, 0
    for _, reading in ipairs(readings) do
      local effect = first.effect_name == 'A12' and tonumber(of_reading[reading][place].effect)
      if effect then
        known = known + 1
        up, down = up + (effect > 0.5 and 1 or 0), down + (effect < 0.5 and 1 or 0)
      end
    end
    if known == #readings then
      total = total + 1
      if up == known or down == known then shared = shared + 1 end
    end
  end
  return ('%d of %d'):format(shared, total)
end

-- ---- The table ----

-- The effect of a claim under a reading, with two decimals unless it is a count, and its verdict.
local function cells_of(row)
  local function short(text) return tonumber(text) % 1 == 0 and typeset.show(text) or ('%.2f'):format(text) end
  local effect = row.effect == '' and '--' or short(row.effect)
  if row.effect ~= '' and row.low ~= '' then effect = ('%s [%s, %s]'):format(effect, short(row.low), short(row.high)) end
  return { effect, claims.verdict_of(row, claims.reached(row)) }
end

-- The setting of a claim, or what its two settings have in common.
local function place_of(row)
  return typeset.short(row.setting_b == '' and row.setting_a or row.setting_a:match '^(.*)%-%w+$' or row.setting_a)
end

-- Every claim under every reading.
function robustness.print_claims()
  local first, rules = { '' }, {}
  for index, reading in ipairs(readings) do
    first[index + 1] = ('\\multicolumn{2}{c}{%s}'):format(titles[reading] or typeset.escape(reading))
    rules[index] = ('\\cmidrule(l{10pt}){%d-%d}'):format(2 * index + 1, 2 * index + 2)
  end
  local lines = {}
  for place, row in ipairs(of_reading[readings[1]]) do
    if claims.headings[row.id] then
      lines[#lines + 1] = ('%s\\multicolumn{%d}{@{}l}{\\itshape %s}\\\\'):format(place > 1 and '\\addlinespace[3pt]' or '',
        2 + 2 * #readings, claims.headings[row.id])
    end
    local cells = { typeset.escape(row.id), place_of(row) }
    for _, reading in ipairs(readings) do
      for _, cell in ipairs(cells_of(of_reading[reading][place])) do cells[#cells + 1] = cell end
    end
    lines[#lines + 1] = typeset.row_of(cells)
  end
  typeset.print_tabular('@{}ll' .. ('@{\\hskip10pt}ll'):rep(#readings) .. '@{\\hskip6pt}',
    { ' & ' .. typeset.row_of(first), table.concat(rules), 'claim & setting' .. (' & effect & verdict'):rep(#readings) .. ' \\\\' }, lines)
end

return robustness
