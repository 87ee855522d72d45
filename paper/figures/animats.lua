-- SPDX-License-Identifier: MIT
-- The frames of the best individuals (planula frames), and how to draw them on a page.
local csv = require 'csv'
local page = require 'page'
local animats = {}

local function number(text) return assert(tonumber(text), 'not a number: ' .. tostring(text)) end

-- Rows of a table in lists, by the texts of these columns.
local function grouped(rows, ...)
  local groups = {}
  for _, row in ipairs(rows) do
    local parts = {}
    for _, column in ipairs { ... } do parts[#parts + 1] = row[column] end
    local key = table.concat(parts, ' ')
    groups[key] = groups[key] or {}
    table.insert(groups[key], row)
  end
  return groups
end

-- The box around the cells of some frames, one radius wider than their centres.
local function box_of(frames)
  local box = { left = math.huge, right = -math.huge, low = math.huge, high = -math.huge }
  for _, frame in ipairs(frames) do
    for _, cell in ipairs(frame.cells) do
      box.left, box.right = math.min(box.left, cell.x - 0.5), math.max(box.right, cell.x + 0.5)
      box.low, box.high = math.min(box.low, cell.y - 0.5), math.max(box.high, cell.y + 0.5)
    end
  end
  return box
end

local tables, settings

function animats.open(frames_folder, data_folder)
  local function read(name) return csv.read(frames_folder .. '/' .. name .. '.csv') end
  tables = {
    frames = grouped(read 'frames', 'setting', 'rank', 'stage'),
    cells = grouped(read 'frame_cells', 'setting', 'rank', 'stage', 'frame'),
    links = grouped(read 'frame_links', 'setting', 'rank', 'stage', 'frame'),
    paths = grouped(read 'frame_paths', 'setting', 'rank'),
    terrain = grouped(read 'frame_terrain', 'setting', 'rank'),
    morphologies = grouped(read 'morphologies', 'setting', 'rank'),
  }
  settings = {}
  for _, row in ipairs(csv.read(data_folder .. '/settings.csv')) do settings[row.setting] = row end
end

-- The row of a setting; nil if the data have no run of it.
function animats.setting(name) return settings[name] end

-- The turn about the origin, as its cosine and sine, by which the way from the first of these places to the last points to
-- the right.
local function turn_of(places)
  local dx, dy = places[#places][1] - places[1][1], places[#places][2] - places[1][2]
  local length = math.sqrt(dx * dx + dy * dy)
  if length == 0 then return { 1, 0 } end
  return { dx / length, -dy / length }
end

local function turned(turn, x, y) return turn[1] * x - turn[2] * y, turn[2] * x + turn[1] * y end

-- The frames of an individual that have cells, turned, with their box; of a body on land the box begins at the ground,
-- which its cells touch with their centres.
local function stage_of(key, stage, grounded, turn)
  local frames = {}
  for _, row in ipairs(tables.frames[key .. ' ' .. stage] or {}) do
    local frame = { step = number(row.step), cells = {}, links = {} }
    local at = key .. ' ' .. stage .. ' ' .. row.frame
    for _, cell in ipairs(tables.cells[at] or {}) do
      local x, y = turned(turn, number(cell.x), number(cell.y))
      frame.cells[#frame.cells + 1] = { x = x, y = y, signal = number(cell.signal) }
    end
    for _, link in ipairs(tables.links[at] or {}) do
      local x1, y1 = turned(turn, number(link.x1), number(link.y1))
      local x2, y2 = turned(turn, number(link.x2), number(link.y2))
      frame.links[#frame.links + 1] = { x1, y1, x2, y2, outline = link.outline == '1' }
    end
    if #frame.cells > 0 then frames[#frames + 1] = frame end
  end
  local wide, high = 0, 0
  for _, frame in ipairs(frames) do
    frame.box = box_of { frame }
    if grounded then frame.box.low = math.min(frame.box.low, -0.5) end
    wide, high = math.max(wide, frame.box.right - frame.box.left), math.max(high, frame.box.high - frame.box.low)
  end
  return { frames = frames, box = box_of(frames), wide = wide, high = high }
end

-- The best individual of the run of this rank; nil if there is none. Gait and path of a swimmer are turned so that it moves
-- to the right.
function animats.individual(setting, rank)
  local key = setting .. ' ' .. rank
  local described = tables.morphologies[key] and tables.morphologies[key][1]
  if not described then return nil end
  local land, still = settings[setting].world == 'terrestrial', { 1, 0 }
  local centres = {}
  for _, row in ipairs(tables.paths[key] or {}) do centres[#centres + 1] = { number(row.x), number(row.y) } end
  if #centres == 0 then return nil end
  local turn = land and still or turn_of(centres)
  for _, place in ipairs(centres) do place[1], place[2] = turned(turn, place[1], place[2]) end
  local one = { land = land, seed = described.seed, cells = number(described.cells), moved = number(described.displacement),
                growth = stage_of(key, 'growth', false, still), gait = stage_of(key, 'gait', land, turn),
                path = stage_of(key, 'path', land, turn), centres = centres, terrain = {} }
  for _, row in ipairs(tables.terrain[key] or {}) do
    local line = row.kind .. ' ' .. row.line
    if not one.terrain[line] then
      one.terrain[line] = {}
      table.insert(one.terrain, one.terrain[line]) -- in the order of the table
    end
    table.insert(one.terrain[line], { number(row.x), number(row.y) })
  end
  return one
end

-- Draws a frame with its origin at (x0, y0); `colour` may be a number for all cells.
function animats.draw(on, frame, x0, y0, scale, colour, springs)
  for _, cell in ipairs(frame.cells) do on:disc(x0 + scale * cell.x, y0 + scale * cell.y, 0.5 * scale, colour or page.signal(cell.signal)) end
  for _, link in ipairs(frame.links) do
    if link.outline or springs then
      on:line(x0 + scale * link[1], y0 + scale * link[2], x0 + scale * link[3], y0 + scale * link[4], link.outline and springs and 'outline' or 'spring')
    end
  end
end

-- The part of a piece of a line between two x, as its ends; nil if there is none.
local function clipped(a, b, left, right)
  if a[1] > b[1] then a, b = b, a end
  if b[1] < left or a[1] > right then return nil end
  local function at(x) return { x, a[2] + (b[2] - a[2]) * (x - a[1]) / (b[1] - a[1]) } end
  return a[1] < left and at(left) or a, b[1] > right and at(right) or b
end

-- Draws the terrain between two x, with its origin at (x0, y0).
function animats.draw_terrain(on, one, x0, y0, scale, left, right)
  for _, line in ipairs(one.terrain) do
    for i = 2, #line do
      local a, b = clipped(line[i - 1], line[i], left, right)
      if a then on:line(x0 + scale * a[1], y0 + scale * a[2], x0 + scale * b[1], y0 + scale * b[2], 'ground') end
    end
  end
end

-- Draws frames side by side in a box with its left upper corner at (left, top), each in the middle of its place; bodies on
-- land keep their distance to the ground, which is drawn below each. Returns the scale.
function animats.row(on, one, stage, left, top, width, height, largest_scale)
  local count = #stage.frames
  local place = width / count
  local scale = math.min(largest_scale, (place - 0.12) / stage.wide, height / stage.high)
  for index, frame in ipairs(stage.frames) do
    local x0 = left + (index - 0.5) * place - scale * (frame.box.left + frame.box.right) / 2
    local y0 = top - height / 2 - scale * (frame.box.low + frame.box.high) / 2
    if stage == one.gait and one.land then
      local middle = (frame.box.left + frame.box.right) / 2
      y0 = top - height + 0.5 * scale
      animats.draw_terrain(on, one, x0, y0, scale, middle - place / scale / 2, middle + place / scale / 2)
    end
    animats.draw(on, frame, x0, y0, scale, stage == one.growth and page.grey or nil, true)
  end
  return scale
end

-- The steps of frames, below each.
function animats.steps(on, stage, left, y, width)
  for index, frame in ipairs(stage.frames) do on:text(left + (index - 0.5) * width / #stage.frames, y, ('%d'):format(frame.step), 'note') end
end

-- Shades of the frames of a path, from its beginning; the last frame has the colours of its signals.
local function shade(index, count) return page.ramp({ { 0, 0xEC, 0xEF, 0xF1 }, { 1, 0x90, 0xA4, 0xAE } }, (index - 1) / math.max(1, count - 2)) end

-- Draws the path of the centre of mass and the frames along it where they were, in a box with its left upper corner at
-- (left, top); on land the ground is at its foot. Returns the scale, and the place of x = 0.
function animats.path(on, one, left, top, width, height, largest_scale)
  local box = { left = one.path.box.left, right = one.path.box.right, low = one.path.box.low, high = one.path.box.high }
  if one.land then box.low = math.min(box.low, -0.5) end
  local scale = math.min(largest_scale, width / (box.right - box.left), height / (box.high - box.low))
  local x0 = left + width / 2 - scale * (box.left + box.right) / 2
  local y0 = one.land and top - height - scale * box.low or top - height / 2 - scale * (box.low + box.high) / 2
  local span = one.land and width / scale / 2 or 0
  local middle = (box.left + box.right) / 2
  animats.draw_terrain(on, one, x0, y0, scale, middle - span, middle + span)
  for index, frame in ipairs(one.path.frames) do
    if index < #one.path.frames then animats.draw(on, frame, x0, y0, scale, shade(index, #one.path.frames), false) end
  end
  on:on_layer(2)
  animats.draw(on, one.path.frames[#one.path.frames], x0, y0, scale, nil, false)
  on:on_layer(3)
  local points = {}
  for _, centre in ipairs(one.centres) do points[#points + 1] = { x0 + scale * centre[1], y0 + scale * centre[2] } end
  on:polyline(points, 'path')
  on:disc(points[1][1], points[1][2], 0.05, 0xD55E00)
  on:on_layer(1)
  return scale, x0
end

return animats
