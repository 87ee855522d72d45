-- SPDX-License-Identifier: MIT
-- A page of discs, lines and texts for gnuplot (page.gp), placed in cm: x from the left, y up, with the head of the page
-- at 0. What is drawn on a later layer covers what is on an earlier one; in a layer lines cover discs, and texts cover all.
-- page.new(folder) gives an empty page, whose save() writes into the folder: cells.tsv (layer, x, y, radius, colour),
-- lines.tsv (layer, x, y, dx, dy, style), labels.tsv (x, y, text, style), in columns apart by tabs, since gnuplot takes a
-- comma in a text for the end of a column; and page.gp (the size of the page).
local page = {}
page.__index = page

page.width = 16.0

-- Styles of lines, as page.gp numbers them.
page.lines = { spring = 1, outline = 2, ground = 3, path = 4, scale = 5, arrow = 6, pale = 7, thin = 8, neat = 9, ns = 10,
               faint = 11, rule = 12, length1 = 13, length2 = 14, length3 = 15, length4 = 16, length5 = 17 }

-- Mixes two colours, each red, green and blue from 0 to 255.
local function mixed(a, b, share)
  local colour = 0
  for i = 1, 3 do colour = colour * 256 + math.floor(a[i] + (b[i] - a[i]) * share + 0.5) end
  return colour
end

-- The colour of a number by a list of stops, { number, red, green, blue }, ascending.
function page.ramp(stops, value)
  for i = 2, #stops do
    local low, high = stops[i - 1], stops[i]
    if value <= high[1] or i == #stops then
      local share = math.max(0, math.min(1, (value - low[1]) / (high[1] - low[1])))
      return mixed({ low[2], low[3], low[4] }, { high[2], high[3], high[4] }, share)
    end
  end
end

-- The colour of an actuation signal, from contraction (red) to expansion (blue), and that of cells without one.
local signals = { { -1, 0xB2, 0x18, 0x2B }, { -0.5, 0xEF, 0x8A, 0x62 }, { 0, 0xF4, 0xF1, 0xEA }, { 0.5, 0x67, 0xA9, 0xCF }, { 1, 0x21, 0x66, 0xAC } }
function page.signal(value) return page.ramp(signals, value) end
page.grey = 0xCFD8DC

function page.new(folder)
  return setmetatable({ folder = folder, layer = 1, layers = 1,
    files = { cells = { 'layer\tx\ty\tradius\tcolour' }, lines = { 'layer\tx\ty\tdx\tdy\tstyle' }, labels = { 'x\ty\ttext\tstyle' } } }, page)
end

local function write(self, name, pattern, ...) table.insert(self.files[name], pattern:format(...)) end

-- What follows is drawn on this layer, the first of them 1.
function page:on_layer(layer) self.layer, self.layers = layer, math.max(self.layers, layer) end

function page:disc(x, y, radius, colour) write(self, 'cells', '%d\t%.4f\t%.4f\t%.4f\t%d', self.layer, x, y, radius, colour) end

function page:line(x1, y1, x2, y2, style)
  write(self, 'lines', '%d\t%.4f\t%.4f\t%.4f\t%.4f\t%d', self.layer, x1, y1, x2 - x1, y2 - y1, assert(page.lines[style], style))
end

-- A line through points { x, y }.
function page:polyline(points, style)
  for i = 2, #points do self:line(points[i - 1][1], points[i - 1][2], points[i][1], points[i][2], style) end
end

-- An arc or a circle of straight pieces; angles in degrees.
function page:arc(x, y, radius, style, from, to)
  local points, pieces = {}, 48
  for i = 0, pieces do
    local angle = math.rad((from or 0) + ((to or 360) - (from or 0)) * i / pieces)
    points[#points + 1] = { x + radius * math.cos(angle), y + radius * math.sin(angle) }
  end
  self:polyline(points, style)
end

-- Styles of texts: letter (bold), title, note (small, grey, centred), left and right (small, dark), quiet (small, grey),
-- missing (grey).
function page:text(x, y, text, style) write(self, 'labels', '%.4f\t%.4f\t%s\t%s', x, y, text, style) end

-- The head of a panel.
function page:title(x, y, letter, text)
  self:text(x, y, letter, 'letter')
  self:text(letter == '' and x or x + 0.5, y, text, 'title')
end

-- A bar of some whole number of cell diameters, with its length.
function page:bar(x, y, scale, length)
  self:line(x, y, x + scale * length, y, 'scale')
  self:text(x + scale * length + 0.1, y, ('%g'):format(length), 'left')
end

-- A length in 1, 2, 5, 10 … near the given one.
function page.round_length(length)
  local power = 10 ^ math.floor(math.log(length, 10))
  for _, factor in ipairs { 5, 2, 1 } do if factor * power <= length then return factor * power end end
  return power
end

function page:save(foot)
  for name, lines in pairs(self.files) do
    local file = assert(io.open(self.folder .. '/' .. name .. '.tsv', 'w'))
    file:write(table.concat(lines, '\n'), '\n')
    file:close()
  end
  local file = assert(io.open(self.folder .. '/page.gp', 'w'))
  file:write(('width = %.4f\nheight = %.4f\nlayers = %d\n'):format(page.width, math.max(1, -foot), self.layers))
  file:close()
end

return page
