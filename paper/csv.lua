-- SPDX-License-Identifier: MIT
-- Reads tables in comma-separated form after RFC 4180: one header line; fields may be quoted, then hold commas, line
-- breaks and doubled quotes. A row is a table from column name to text; an absent value is the empty text.
local csv = {}

-- Splits the text of a file into records, each a list of fields.
local function records(text, file)
  local list, record, position = {}, {}, 1
  while position <= #text do
    local field
    if text:sub(position, position) == '"' then
      -- A quoted field ends at the first quote that is not doubled.
      local start = position + 1
      position = start
      repeat
        local quote = text:find('"', position, true)
        assert(quote, file .. ": a quoted field does not end")
        position = quote + 2
      until text:sub(quote + 1, quote + 1) ~= '"'
      field = text:sub(start, position - 3):gsub('""', '"')
      position = position - 1
    else
      field = text:match('^[^,\r\n]*', position)
      position = position + #field
    end
    record[#record + 1] = field
    -- A comma goes on with the record; the end of a line, or of the file, ends it.
    local separator = text:match('^,', position) or text:match('^\r?\n', position) or ''
    assert(separator ~= '' or position > #text, file .. ": text after a quoted field in record " .. #list + 1)
    position = position + #separator
    if separator == ',' and position > #text then record[#record + 1] = '' end
    if separator ~= ',' or position > #text then
      list[#list + 1], record = record, {}
    end
  end
  return list
end

-- The rows of a table, in the order of the file.
function csv.read(file)
  local handle = assert(io.open(file, 'rb'))
  local list = records(handle:read('a'), file)
  handle:close()
  local header = assert(list[1], file .. ": no header line")
  local rows = {}
  for number = 2, #list do
    assert(#list[number] == #header, ("%s: record %d has %d fields instead of %d"):format(file, number, #list[number], #header))
    local row = {}
    for index, name in ipairs(header) do row[name] = list[number][index] end
    rows[#rows + 1] = row
  end
  return rows
end

-- The rows that hold the given texts: csv.where(rows, { setting = 'osc-aq-ns' }).
function csv.where(rows, wanted)
  local chosen = {}
  for _, row in ipairs(rows) do
    local fits = true
    for name, text in pairs(wanted) do fits = fits and row[name] == text end
    if fits then chosen[#chosen + 1] = row end
  end
  return chosen
end

-- The numbers of a column; rows without one are left out.
function csv.numbers(rows, column)
  local numbers = {}
  for _, row in ipairs(rows) do numbers[#numbers + 1] = tonumber(row[column]) end
  return numbers
end

-- The median of a list of numbers, which it sorts; of none the empty text.
function csv.median(values)
  table.sort(values)
  local middle = #values // 2
  if #values == 0 then return '' end
  return #values % 2 == 1 and values[middle + 1] or (values[middle] + values[middle + 1]) / 2
end

-- A table of two columns, key and value, as one Lua table.
function csv.pairs_of(file)
  local map = {}
  for _, row in ipairs(csv.read(file)) do map[row.key] = row.value end
  return map
end

return csv
