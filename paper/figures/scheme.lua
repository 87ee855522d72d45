-- SPDX-License-Identifier: MIT
-- Lays out Figure 2: the network of a cell with its inputs and outputs, and where the cells are told that they are; an
-- embryo of discs and springs; the mesh of the finished body with the rest lengths of its springs.
--
--   texlua paper/figures/scheme.lua FRAMES DATA OUT SETTING
package.path = 'paper/?.lua;paper/figures/?.lua;' .. package.path
local animats = require 'animats'
local csv = require 'csv'
local page = require 'page'

local frames_folder, data_folder, out, setting = table.unpack(arg)
animats.open(frames_folder, data_folder)
local parameter = {}
for _, row in ipairs(csv.read(data_folder .. '/parameters.csv')) do parameter[row.name] = tonumber(row.standard) end
local on = page.new(out)
local one = animats.individual(setting, 1)

-- ---- A: the network of a cell ----

local inputs = { 'position X', 'position Y', 'maternal morphogen, east', 'maternal morphogen, west', 'maternal morphogen, north',
                 'maternal morphogen, south', 'morphogen of the neighbours, mean', 'time, from 0 to 1', 'bias, always 1' }
local outputs = { { 'inhibitor: no division if > 0' }, { 'division angle' }, { 'apoptosis: death if > 0' }, { 'morphogen, to the neighbours' },
                  { 'period', 'oscillators only', 'neat' }, { 'phase', 'oscillators only', 'neat' }, { 'muscle signal', 'gene network only', 'ns' } }

local function draw_network(left, top, height)
  on:title(left, top - 0.25, 'A', 'the control network, the same in every cell')
  local box_left, box_right, foot = left + 4.5, left + 6.8, top - 0.7 - height
  local function slot(index, count) return top - 0.7 - (index - 0.5) * height / count end
  local in_x, out_x = box_left + 0.45, box_right - 0.45
  for i = 1, #inputs do
    for j = 1, #outputs do on:line(in_x, slot(i, #inputs), out_x, slot(j, #outputs), 'faint') end
  end
  for index, name in ipairs(inputs) do
    local y = slot(index, #inputs)
    on:text(box_left - 0.6, y, name, 'right')
    on:line(box_left - 0.5, y, in_x - 0.14, y, 'arrow')
    on:disc(in_x, y, 0.11, page.grey)
    on:arc(in_x, y, 0.11, 'thin')
  end
  for index, name in ipairs(outputs) do
    local y = slot(index, #outputs)
    on:disc(out_x, y, 0.11, 0xF4F1EA)
    on:arc(out_x, y, 0.11, name[3] or 'thin')
    on:line(out_x + 0.14, y, box_right + 0.5, y, 'arrow')
    on:text(box_right + 0.6, y + (name[2] and 0.11 or 0), name[1], 'left')
    if name[2] then on:text(box_right + 0.6, y - 0.16, name[2], 'quiet') end
  end
  -- The cell: a box with round corners.
  local r = 0.4
  for _, corner in ipairs { { box_right - r, top - 0.7 - r, 0 }, { box_left + r, top - 0.7 - r, 90 }, { box_left + r, foot + r, 180 }, { box_right - r, foot + r, 270 } } do
    on:arc(corner[1], corner[2], r, 'rule', corner[3], corner[3] + 90)
  end
  on:line(box_left + r, top - 0.7, box_right - r, top - 0.7, 'rule')
  on:line(box_left + r, foot, box_right - r, foot, 'rule')
  on:line(box_left, foot + r, box_left, top - 0.7 - r, 'rule')
  on:line(box_right, foot + r, box_right, top - 0.7 - r, 'rule')
end

-- ---- B: where cells are ----

local function draw_places(left, top, side)
  on:title(left, top - 0.25, 'B', 'positional information')
  local reach = 1.45 * parameter.morphogen_distance
  local scale = side / (2 * reach)
  local x0, y0 = left + side / 2, top - 0.7 - side / 2
  local function clipped_arc(x, y, radius) -- only within the square
    local points = {}
    for i = 0, 96 do
      local angle = 2 * math.pi * i / 96
      local px, py = x + radius * math.cos(angle), y + radius * math.sin(angle)
      if math.max(math.abs(px), math.abs(py)) <= reach then
        points[#points + 1] = { x0 + scale * px, y0 + scale * py }
      else
        on:polyline(points, 'pale')
        points = {}
      end
    end
    on:polyline(points, 'pale')
  end
  local d = parameter.morphogen_distance
  for _, source in ipairs { { d, 0, 'E' }, { -d, 0, 'W' }, { 0, d, 'N' }, { 0, -d, 'S' } } do
    for _, radius in ipairs { 0.25, 0.5, 0.75, 1 } do clipped_arc(source[1], source[2], radius * d) end
  end
  on:line(x0 - scale * reach, y0, x0 + scale * reach, y0, 'arrow')
  on:line(x0, y0 - scale * reach, x0, y0 + scale * reach, 'arrow')
  on:text(x0 + scale * reach - 0.02, y0 - 0.22, 'X', 'right')
  on:text(x0 + 0.12, y0 + scale * reach - 0.1, 'Y', 'left')
  if one then animats.draw(on, one.growth.frames[#one.growth.frames], x0, y0, scale, page.grey, true) end
  on:on_layer(2)
  for _, source in ipairs { { d, 0 }, { -d, 0 }, { 0, d }, { 0, -d } } do on:disc(x0 + scale * source[1], y0 + scale * source[2], 0.1, 0x009E73) end
  on:on_layer(1)
  on:bar(left, top - 0.7 - side - 0.1, scale, 5)
end

-- ---- C: an embryo ----

-- The frame of growth that shows single cells and their springs best.
local function embryo()
  local best
  for _, frame in ipairs(one.growth.frames) do
    if not best or math.abs(#frame.cells - 24) < math.abs(#best.cells - 24) then best = frame end
  end
  return best
end

local function draw_embryo(left, top, width, height)
  on:title(left, top - 0.25, 'C', 'growth: discs and springs')
  if not one then return on:text(left, top - 0.9, 'This copy has no individual to show.', 'missing') end
  local frame = embryo()
  local box = frame.box
  local scale = math.min(0.6, width / (box.right - box.left), height / (box.high - box.low))
  local x0, y0 = left + width / 2 - scale * (box.left + box.right) / 2, top - 0.7 - height / 2 - scale * (box.low + box.high) / 2
  animats.draw(on, frame, x0, y0, scale, page.grey, true)
  for _, cell in ipairs(frame.cells) do on:arc(x0 + scale * cell.x, y0 + scale * cell.y, 0.5 * scale, 'pale') end
  on:bar(left, top - 0.7 - height - 0.1, scale, 1)
  on:text(left + scale + 0.4, top - 0.7 - height - 0.1, ('(cell diameter); step %d, %d cells'):format(frame.step, #frame.cells), 'left')
end

-- ---- D: the mesh ----

-- Classes of rest length, each with its upper end; page.gp has a style of lines for each.
local classes = { { 0.9, 'length1', '< 0.9' }, { 0.97, 'length2', '0.9 to 0.97' }, { 1.03, 'length3', '0.97 to 1.03' },
                  { 1.1, 'length4', '1.03 to 1.1' }, { math.huge, 'length5', '> 1.1' } }

local function draw_mesh(left, top, width, height)
  on:title(left, top - 0.25, 'D', 'body: mesh and rest lengths')
  if not one then return on:text(left, top - 0.9, 'This copy has no individual to show.', 'missing') end
  local frame = one.growth.frames[#one.growth.frames]
  local box, room = frame.box, width - 2.1
  local scale = math.min(0.5, room / (box.right - box.left), height / (box.high - box.low))
  local x0, y0 = left + room / 2 - scale * (box.left + box.right) / 2, top - 0.7 - height / 2 - scale * (box.low + box.high) / 2
  for _, link in ipairs(frame.links) do
    local length = math.sqrt((link[3] - link[1]) ^ 2 + (link[4] - link[2]) ^ 2)
    local class = 1
    while length > classes[class][1] do class = class + 1 end
    on:line(x0 + scale * link[1], y0 + scale * link[2], x0 + scale * link[3], y0 + scale * link[4], classes[class][2])
  end
  on:on_layer(2)
  for _, cell in ipairs(frame.cells) do on:disc(x0 + scale * cell.x, y0 + scale * cell.y, 0.035, 0x333333) end
  on:on_layer(1)
  for index, class in ipairs(classes) do
    local y = top - 0.7 - height / 2 + (index - 3) * 0.36
    on:line(left + width - 2.15, y, left + width - 1.5, y, class[2])
    on:text(left + width - 1.4, y, class[3], 'left')
  end
  on:text(left + width - 2.15, top - 0.7 - height / 2 + 3 * 0.36, 'rest length', 'left')
  on:bar(left, top - 0.7 - height - 0.1, scale, 2)
end

draw_network(0, 0, 4.6)
draw_places(11.4, 0, 4.6)
draw_embryo(0, -5.9, 6.0, 4.4)
draw_mesh(7.2, -5.9, 8.8, 4.4)
on:save(-5.9 - 0.7 - 4.4 - 0.4)
