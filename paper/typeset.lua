-- SPDX-License-Identifier: MIT
-- Texts, numbers and tables as TeX shows them. A value that is not a number shows as a dash.
local typeset = {}

local symbols = {
  ['\\'] = '\\textbackslash{}', ['{'] = '\\{', ['}'] = '\\}', ['~'] = '\\textasciitilde{}', ['^'] = '\\textasciicircum{}',
  ['&'] = '\\&', ['%'] = '\\%', ['$'] = '\\$', ['#'] = '\\#', ['_'] = '\\_',
  ['≥'] = '$\\ge$', ['≤'] = '$\\le$', ['≠'] = '$\\ne$', ['≈'] = '$\\approx$', ['×'] = '$\\times$', ['−'] = '$-$', ['±'] = '$\\pm$',
  ['·'] = '$\\cdot$', ['∞'] = '$\\infty$', ['α'] = '$\\alpha$', ['ℓ'] = '$\\ell$', ['δ'] = '$\\delta$', ['ρ'] = '$\\rho$', ['∇'] = '$\\nabla$', ['λ'] = '$\\lambda$',
  ['μ'] = '$\\mu$', ['π'] = '$\\pi$', ['φ'] = '$\\phi$', ['→'] = '$\\to$', ['<'] = '\\textless{}', ['>'] = '\\textgreater{}',
  ['"'] = '\\textquotedbl{}', ['|'] = '\\textbar{}',
}

-- Plain text as TeX shows it literally.
function typeset.escape(text) return (text:gsub(utf8.charpattern, symbols)) end

-- Words between backticks are set in the typewriter face, words between asterisks are emphasised.
function typeset.marked_up(text)
  text = text:gsub('`([^`]+)`', '\\texttt{%1}'):gsub('%*%*([^*]+)%*%*', '\\textbf{%1}')
  return (text:gsub('%*([^*]+)%*', '\\emph{%1}'))
end

-- Whole numbers with a thin space between groups of three digits: 11 520.
local function grouped(digits)
  if #digits <= 4 then return digits end
  local groups = {}
  while #digits > 3 do
    table.insert(groups, 1, digits:sub(-3))
    digits = digits:sub(1, -4)
  end
  table.insert(groups, 1, digits)
  return table.concat(groups, '\\,')
end

-- A number of the tables for reading: whole ones in full, others with three significant digits.
function typeset.show(text)
  local value = tonumber(text)
  if not value or value ~= value then return '--' end
  if math.abs(value) == math.huge then return value > 0 and '$\\infty$' or '$-\\infty$' end
  local sign = value < 0 and '$-$' or ''
  value = math.abs(value)
  if value == math.floor(value) and value < 1e9 then return sign .. grouped(('%d'):format(value)) end
  if value >= 999.5 then return sign .. grouped(('%.0f'):format(value)) end
  if value >= 1e-3 then
    local decimals = math.max(0, 2 - math.floor(math.log(value, 10) + 1e-12))
    return sign .. ('%.' .. decimals .. 'f'):format(value)
  end
  local mantissa, exponent = ('%.1e'):format(value):match '^(.-)e(.*)$'
  return ('%s$%s\\cdot10^{%d}$'):format(sign, mantissa, tonumber(exponent))
end

-- A probability: two significant digits.
function typeset.probability(text)
  local value = tonumber(text)
  if not value or value ~= value then return '--' end
  if value < 1e-4 then return '$<10^{-4}$' end
  return ('%.' .. math.max(2, 1 - math.floor(math.log(value, 10) + 1e-12)) .. 'f'):format(value)
end

-- A number as the table gives it, with powers of ten set as such (1e-4, 0.40); a long one that is a power of two as that.
function typeset.literal(text)
  local mantissa, exponent = text:match '^(%-?[%d.]+)e([+-]?%d+)$'
  local binary = mantissa and math.floor(math.log(math.abs(tonumber(text)), 2) + 0.5)
  if binary and #mantissa > 8 and 2.0 ^ binary == tonumber(text) then return ('$2^{%d}$'):format(binary) end
  if not mantissa then return (typeset.escape(text):gsub('^%-', '$-$')) end
  local factor = mantissa == '1' and '' or mantissa .. '\\cdot'
  return ('$%s10^{%d}$'):format(factor, tonumber(exponent))
end

-- Round millions in words: 96 million.
function typeset.in_words(text)
  local value = tonumber(text)
  if value and value >= 1e6 and value % 1e5 == 0 then return typeset.show(value / 1e6) .. ' million' end
  return typeset.show(text)
end

-- A number of a row, with its interval if the row has one.
function typeset.interval(row, middle)
  if row.low == '' or row.high == '' then return typeset.show(row[middle]) end
  return ('%s [%s, %s]'):format(typeset.show(row[middle]), typeset.show(row.low), typeset.show(row.high))
end

-- The name of a setting: osc-aq-ns is OSC AQ NS.
function typeset.short(setting) return typeset.escape((setting:upper():gsub('%-', ' '))) end

-- A share in per cent.
function typeset.percent_of(text) return tonumber(text) and ('%.1f'):format(100 * tonumber(text)) or '--' end

-- A row of cells.
function typeset.row_of(cells) return table.concat(cells, ' & ') .. ' \\\\' end

-- Prints a table: its columns, the lines of its head and those of its rows.
function typeset.print_tabular(columns, head, lines)
  tex.print { '\\begin{tabular}{' .. columns .. '}', '\\toprule' }
  tex.print(head)
  tex.print '\\midrule'
  tex.print(lines)
  tex.print '\\bottomrule\\end{tabular}'
end

return typeset
