-- SPDX-License-Identifier: MIT
-- Lays out portraits of animats for gnuplot: a row of growth frames and a row of gait frames for each setting, both at
-- the same scale, so that a cell has the same size in all frames.
--
--   texlua paper/figures/morphologies.lua FRAMES DATA OUT SETTING...
--
-- writes the folder OUT: cells.csv (x,y,radius,signal,stage), links.csv (x,y,dx,dy,outline), grounds.csv (x,y,dx),
-- labels.csv (x,y,text,style) and page.gp (the page's size). All lengths are cm on the page, y up from its foot.
package.path = 'paper/?.lua;' .. package.path
local csv = require 'csv'

local frames_folder, data_folder, out = arg[1], arg[2], arg[3]
local width, gap, title_height, margin = 16.0, 0.12, 0.62, 0.35
local largest_height, largest_scale = 3.4, 0.16 -- cm of a row, cm of a cell diameter

local function number(text) return assert(tonumber(text), 'not a number: ' .. tostring(text)) end

-- Rows of a table, grouped by setting, stage and frame.
local function grouped(name)
  local groups = {}
  for _, row in ipairs(csv.read(frames_folder .. '/' .. name .. '.csv')) do
    local key = row.setting .. ' ' .. row.stage .. ' ' .. row.frame
    groups[key] = groups[key] or {}
    table.insert(groups[key], row)
  end
  return groups
end

-- The box around the cells of a frame, one radius wider than their centres.
local function box_of(cells)
  local box = { left = math.huge, right = -math.huge, low = math.huge, high = -math.huge }
  for _, cell in ipairs(cells) do
    local x, y = number(cell.x), number(cell.y)
    box.left, box.right = math.min(box.left, x - 0.5), math.max(box.right, x + 0.5)
    box.low, box.high = math.min(box.low, y - 0.5), math.max(box.high, y + 0.5)
  end
  return box
end

local cells_of, links_of = grouped 'frame_cells', grouped 'frame_links'
local frame_rows = csv.read(frames_folder .. '/frames.csv')
local settings, portraits = {}, {}
for _, row in ipairs(csv.read(data_folder .. '/settings.csv')) do settings[row.setting] = row end
for _, row in ipairs(csv.read(frames_folder .. '/morphologies.csv')) do portraits[row.setting] = row end

-- The frames of a setting that have cells, by stage, each with its box, and the largest box. A body on land moves above
-- the ground at height 0, which its cells touch with their centres: there the box begins, one radius lower.
local function stage_of(setting, stage)
  local grounded = stage == 'gait' and settings[setting].world == 'terrestrial'
  local frames, wide, high = {}, 0, 0
  for _, row in ipairs(csv.where(frame_rows, { setting = setting, stage = stage })) do
    local key = setting .. ' ' .. stage .. ' ' .. row.frame
    if cells_of[key] then
      local box = box_of(cells_of[key])
      if grounded then box.low = -0.5 end
      wide, high = math.max(wide, box.right - box.left), math.max(high, box.high - box.low)
      frames[#frames + 1] = { step = row.step, box = box, cells = cells_of[key], links = links_of[key] or {} }
    end
  end
  return { name = stage, grounded = grounded, frames = frames, wide = wide, high = high }
end

local files = {}
local function write(name, pattern, ...) files[name][#files[name] + 1] = pattern:format(...) end
files.cells, files.links = { 'x,y,radius,signal,stage' }, { 'x,y,dx,dy,outline' }
files.grounds, files.labels = { 'x,y,dx' }, { 'x,y,text,style' }

-- Draws one row of frames below height `top`; returns the height of its foot. Bodies on land keep their distance to the
-- ground; all others are centred.
local function draw_row(stage, scale, top)
  local height = stage.high * scale
  local cell_width = (width - 2 * margin) / #stage.frames
  if stage.grounded then write('grounds', '%.4f,%.4f,%.4f', margin, top - height, width - 2 * margin) end
  for index, frame in ipairs(stage.frames) do
    local x0 = margin + (index - 0.5) * cell_width - scale * (frame.box.left + frame.box.right) / 2
    local y0 = top - height / 2 - scale * (frame.box.low + frame.box.high) / 2
    if stage.grounded then y0 = top - height + 0.5 * scale end
    for _, cell in ipairs(frame.cells) do
      write('cells', '%.4f,%.4f,%.4f,%.4f,%s', x0 + scale * number(cell.x), y0 + scale * number(cell.y), 0.5 * scale,
            number(cell.signal), stage.name)
    end
    for _, link in ipairs(frame.links) do
      write('links', '%.4f,%.4f,%.4f,%.4f,%s', x0 + scale * number(link.x1), y0 + scale * number(link.y1),
            scale * (number(link.x2) - number(link.x1)), scale * (number(link.y2) - number(link.y1)), link.outline)
    end
    write('labels', '%.4f,%.4f,%s,step', margin + (index - 0.5) * cell_width, top - height - 0.22, frame.step)
  end
  return top - height - 0.45
end

-- From the head of the page (y = 0) downwards.
local y = 0
for index = 4, #arg do
  local setting = arg[index]
  local row, portrait = settings[setting], portraits[setting]
  if row and portrait then
    local growth, gait = stage_of(setting, 'growth'), stage_of(setting, 'gait')
    -- The widest frame fits its place and the highest its row; a small body is not enlarged beyond largest_scale.
    local place = (width - 2 * margin) / math.max(#growth.frames, #gait.frames)
    local scale = math.min(largest_scale, (place - gap) / math.max(growth.wide, gait.wide),
                           largest_height / math.max(growth.high, gait.high))
    write('labels', '%.4f,%.4f,%s,letter', 0, y - 0.3, string.char(string.byte 'A' + index - 4))
    write('labels', '%.4f,%.4f,%s · %s · %s · moved %.1f cell diameters · %s cells,title', 0.55, y - 0.3,
          row.actuation == 'grn' and 'GRN' or 'oscillators', row.world == 'aquatic' and 'water' or 'land',
          row.search == 'novelty' and 'novelty search' or 'NEAT', number(portrait.displacement), portrait.cells)
    y = draw_row(growth, scale, y - title_height)
    y = draw_row(gait, scale, y - 0.1) - 0.25
  end
end

-- Written once everything is placed.
for name, lines in pairs(files) do
  local file = assert(io.open(out .. '/' .. name .. '.csv', 'w'))
  file:write(table.concat(lines, '\n'), '\n')
  file:close()
end
local page = assert(io.open(out .. '/page.gp', 'w'))
page:write(('width = %.4f\nheight = %.4f\n'):format(width, math.max(1, -y)))
page:close()
