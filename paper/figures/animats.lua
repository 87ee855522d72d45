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

-- The frames of an individual that have cells, turned, with their box; of a body on flat ground the box begins there, where
-- cells touch it with their centres.
local function stage_of(key, stage, flat, turn)
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
    if flat then frame.box.low = math.min(frame.box.low, -0.5) end
    wide, high = math.max(wide, frame.box.right - frame.box.left), math.max(high, frame.box.high - frame.box.low)
  end
  return { frames = frames, box = box_of(frames), wide = wide, high = high }
end

-- The lines of an individual's world, and whether they are flat ground at a height of 0.
local function terrain_of(key)
  local terrain, flat = {}, true
  for _, row in ipairs(tables.terrain[key] or {}) do
    local line = row.kind .. ' ' .. row.line
    if not terrain[line] then
      terrain[line] = {}
      table.insert(terrain, terrain[line]) -- in the order of the table
    end
    table.insert(terrain[line], { number(row.x), number(row.y) })
    flat = flat and row.kind == 'ground' and number(row.y) == 0
  end
  return terrain, flat and #terrain > 0
end

-- The best individual of the run of this rank; nil if there is none. Gait and path of a swimmer are turned so that it moves
-- to the right, unless there is something in its world.
function animats.individual(setting, rank)
  local key = setting .. ' ' .. rank
  local described = tables.morphologies[key] and tables.morphologies[key][1]
  if not described then return nil end
  local still = { 1, 0 }
  local centres = {}
  for _, row in ipairs(tables.paths[key] or {}) do centres[#centres + 1] = { number(row.x), number(row.y) } end
  if #centres == 0 then return nil end
  local terrain, flat = terrain_of(key)
  local turn = #terrain > 0 and still or turn_of(centres)
  for _, place in ipairs(centres) do place[1], place[2] = turned(turn, place[1], place[2]) end
  return { flat = flat, seed = described.seed, cells = number(described.cells), moved = number(described.displacement),
           growth = stage_of(key, 'growth', false, still), gait = stage_of(key, 'gait', flat, turn),
           path = stage_of(key, 'path', flat, turn), centres = centres, terrain = terrain }
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

-- The part of a piece of a line within bounds, as its ends; nil if there is none.
local function clipped(a, b, bounds)
  local from, to = 0, 1
  for axis, ends in ipairs(bounds) do
    local start, change = a[axis], b[axis] - a[axis]
    if change == 0 then
      if start < ends[1] or start > ends[2] then return nil end
    else
      local first, second = (ends[1] - start) / change, (ends[2] - start) / change
      from, to = math.max(from, math.min(first, second)), math.min(to, math.max(first, second))
    end
  end
  if from > to then return nil end
  local function at(share) return { a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]) } end
  return at(from), at(to)
end

-- Draws the terrain within bounds { { left, right }, { low, high } }, with its origin at (x0, y0).
function animats.draw_terrain(on, one, x0, y0, scale, bounds)
  for _, line in ipairs(one.terrain) do
    for i = 2, #line do
      local a, b = clipped(line[i - 1], line[i], bounds)
      if a then on:line(x0 + scale * a[1], y0 + scale * a[2], x0 + scale * b[1], y0 + scale * b[2], 'ground') end
    end
  end
end

-- Draws frames side by side in a box with its left upper corner at (left, top); bodies on flat ground keep their distance
-- to it, others in a world with terrain stand at the foot of the box. The terrain is drawn about each. Returns the scale.
function animats.row(on, one, stage, left, top, width, height, largest_scale)
  local count = #stage.frames
  local place = width / count
  local scale = math.min(largest_scale, (place - 0.12) / stage.wide, height / stage.high)
  for index, frame in ipairs(stage.frames) do
    local middle = (frame.box.left + frame.box.right) / 2
    local x0 = left + (index - 0.5) * place - scale * middle
    local y0 = top - height / 2 - scale * (frame.box.low + frame.box.high) / 2
    if stage == one.gait and #one.terrain > 0 then
      y0 = top - height - scale * (one.flat and -0.5 or frame.box.low)
      local half, foot = place / scale / 2, (top - height - y0) / scale
      animats.draw_terrain(on, one, x0, y0, scale, { { middle - half, middle + half }, { foot - 1, foot + height / scale } })
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
-- (left, top); where there is ground it is at its foot. Returns the scale, and the place of x = 0.
function animats.path(on, one, left, top, width, height, largest_scale)
  local box = { left = one.path.box.left, right = one.path.box.right, low = one.path.box.low, high = one.path.box.high }
  if one.flat then box.low = math.min(box.low, -0.5) end
  local scale = math.min(largest_scale, width / (box.right - box.left), height / (box.high - box.low))
  local x0 = left + width / 2 - scale * (box.left + box.right) / 2
  local grounded = #one.terrain > 0
  local y0 = grounded and top - height - scale * box.low or top - height / 2 - scale * (box.low + box.high) / 2
  local half, middle = width / scale / 2, (box.left + box.right) / 2
  animats.draw_terrain(on, one, x0, y0, scale, { { middle - half, middle + half }, { box.low - 1, box.low + height / scale + 0.5 } })
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
