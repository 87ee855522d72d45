-- SPDX-License-Identifier: MIT
-- Lays out the pictures of the best individuals: Figures 1, 3, 4 and 5, the portrait of a single one, and those of any
-- experiment, on a page or on a card of the gallery.
--
--   texlua paper/figures/individuals.lua FIGURE FRAMES DATA OUT [SETTING | LIST]
--
-- FIGURE is fig01_development, fig03_…, fig04_…, fig05_…, portrait, bodies or card; SETTING is that of fig01_development
-- and portrait, LIST the file in which plan.lua has written the settings of bodies and card.
package.path = 'paper/?.lua;paper/figures/?.lua;' .. package.path
local animats = require 'animats'
local page = require 'page'

local figure, frames_folder, data_folder, out, chosen = table.unpack(arg)
animats.open(frames_folder, data_folder)
local on = page.new(out)
local width, indent, ranks = page.width, 0.35, 3

local function short(setting) return (setting:upper():gsub('%-', ' ')) end
local function name_of_search(setting) return setting:match '%-ns$' and 'novelty search' or 'NEAT' end
local function name_of_world(setting) return setting:match '%-te%-' and 'land' or 'water' end

-- Why there is no individual of this rank.
local function missing(setting, rank)
  local row = animats.setting(setting)
  local runs = row and tonumber(row.runs) or 0
  if runs == 0 then return ('This copy has no run of %s.'):format(short(setting)) end
  if runs < rank then return ('This copy has only %d of the %d runs of %s that belong here.'):format(runs, ranks, short(setting)) end
  return ('Run %d of %s has no viable individual.'):format(rank, short(setting))
end

local function described(one, rank)
  return ('%srun of seed %s: moved %.1f cell diameters, %d cells'):format(rank and rank .. '.  ' or '', one.seed, one.moved, one.cells)
end

-- The line above an individual: what it is, and the scales of its frames and of its path.
local function head(one, rank, y, scale, path_scale)
  on:text(indent, y, described(one, rank), 'left')
  on:text(width - 4.0, y, 'frames', 'right')
  on:bar(width - 3.9, y, scale, page.round_length(0.9 / scale))
  on:text(width - 1.7, y, 'path', 'right')
  on:bar(width - 1.6, y, path_scale, page.round_length(0.9 / path_scale))
end

-- Where the path of an individual lies vertically.
local function path_low(one) return one.flat and math.min(one.path.box.low, -0.5) or one.path.box.low end

-- How high something is drawn in a width, at most `height`.
local function fitting(high, wide, width_of_place, height, largest) return math.min(height, high * math.min(largest, width_of_place / wide)) end
local function gait_height(one, room, height, largest)
  return fitting(one.gait.high, one.gait.wide, room / #one.gait.frames - 0.12, height, largest)
end
local function path_height(one, room, height, largest)
  return fitting(one.path.box.high - path_low(one), one.path.box.right - one.path.box.left, room, height, largest)
end

-- One individual with its path beside the frames of its gait.
local function beside(one, rank, y, height, largest)
  local half = (width - indent) / 2
  local high = math.max(gait_height(one, half - 0.3, height, largest), path_height(one, half, height, largest))
  local scale = animats.row(on, one, one.gait, indent, y - 0.34, half - 0.3, high, largest)
  local path_scale = animats.path(on, one, indent + half, y - 0.34, half, high, largest)
  head(one, rank, y - 0.12, scale, path_scale)
  return y - high - 0.56
end

-- One individual with its path below the frames of its gait.
local function above(one, rank, y, height, largest)
  local room = width - indent
  local high, path_high = gait_height(one, room, height, largest), path_height(one, room, height, largest)
  local scale = animats.row(on, one, one.gait, indent, y - 0.35, room, high, largest)
  local path_scale = animats.path(on, one, indent, y - 0.55 - high, room, path_high, largest)
  head(one, rank, y - 0.12, scale, path_scale)
  return y - high - path_high - 0.8
end

-- The best of each shown run of a setting below the title of its panel; draw(one, rank, y) returns the foot.
local function panel(letter, setting, title, y, draw)
  on:title(0, y - 0.25, letter, title)
  y = y - 0.55
  for rank = 1, ranks do
    local one = animats.individual(setting, rank)
    if one then
      y = draw(one, rank, y)
    elseif rank == 1 or figure ~= 'bodies' then
      on:text(indent, y - 0.25, missing(setting, rank), 'missing')
      y = y - 0.6
      if not animats.setting(setting) then break end
    end
  end
  return y - 0.15
end

-- A panel for each { setting, title }.
local function draw_panels(list, draw)
  local y = 0
  for index, each in ipairs(list) do
    y = panel(#list > 1 and string.char(string.byte 'A' + (index - 1) % 26) or '', each.setting, each.title, y, draw)
  end
  return y
end

-- As the article calls them.
local function of_article(names)
  local list = {}
  for _, name in ipairs(names) do list[#list + 1] = { setting = name, title = ('%s, %s'):format(name_of_search(name), name_of_world(name)) } end
  return list
end

-- Growth and gait of one individual, and its path: 'fig01_development'.
local function draw_development(setting)
  local one = animats.individual(setting, 1)
  if not one then
    on:text(0, -0.4, missing(setting, 1), 'missing')
    return -0.8
  end
  local y, largest = 0, 0.17
  local scale = math.min(largest, (width / 6 - 0.12) / math.max(one.growth.wide, one.gait.wide), 3.2 / math.max(one.growth.high, one.gait.high))
  local function row(letter, title, stage)
    on:title(0, y - 0.25, letter, title)
    local high = stage.high * scale
    animats.row(on, one, stage, 0, y - 0.65, width, high, scale)
    animats.steps(on, stage, 0, y - high - 0.9, width)
    y = y - high - 1.35
  end
  row('A', ('growth of the best individual of %s: step of development'):format(short(setting)), one.growth)
  row('B', 'gait: step of locomotion', one.gait)
  on:bar(0.05, y + 0.12, scale, page.round_length(1.2 / scale))
  on:title(0, y - 0.45, 'C', 'path: step of locomotion, where the body was')
  y = y - 0.8
  local high = path_height(one, width, 5, largest)
  local path_scale, x0 = animats.path(on, one, 0, y, width, high, largest)
  for _, frame in ipairs(one.path.frames) do
    on:text(x0 + path_scale * (frame.box.left + frame.box.right) / 2, y - high - 0.22, ('%d'):format(frame.step), 'note')
  end
  on:bar(0.05, y - high - 0.55, path_scale, page.round_length(1.2 / path_scale))
  return y - high - 0.75
end

-- The rows of growth and gait alone.
local function draw_portrait(setting)
  local one = assert(animats.individual(setting, 1), missing(setting, 1))
  local scale = math.min(0.16, (width / 6 - 0.12) / math.max(one.growth.wide, one.gait.wide), 3.4 / math.max(one.growth.high, one.gait.high))
  local y = -0.3
  for _, stage in ipairs { one.growth, one.gait } do
    animats.row(on, one, stage, 0, y, width, stage.high * scale, scale)
    y = y - stage.high * scale - 0.45
  end
  return y
end

-- Gait and path of the best individual of each setting, without words.
local function draw_card(list)
  local y = -0.3
  for _, each in ipairs(list) do
    local one = animats.individual(each.setting, 1)
    if one then
      local high, path_high = gait_height(one, width, 2.4, 0.2), path_height(one, width, 2.6, 0.2)
      animats.row(on, one, one.gait, 0, y, width, high, 0.2)
      animats.path(on, one, 0, y - high - 0.6, width, path_high, 0.2)
      y = y - high - path_high - 1.3
    end
  end
  return y + 0.3
end

local foot
if figure == 'portrait' then
  foot = draw_portrait(chosen)
elseif figure:match '^fig01' then
  foot = draw_development(chosen)
elseif figure:match '^fig03' then
  foot = draw_panels(of_article { 'osc-aq-neat', 'osc-aq-ns' }, function(one, rank, y) return above(one, rank, y, 1.7, 0.16) end)
elseif figure:match '^fig04' then
  foot = draw_panels(of_article { 'osc-te-neat', 'osc-te-ns' }, function(one, rank, y) return above(one, rank, y, 1.6, 0.16) end)
elseif figure == 'card' then
  foot = draw_card(dofile(chosen))
elseif figure == 'bodies' then
  local list = dofile(chosen)
  ranks = #list <= 2 and 3 or 1
  foot = draw_panels(list, function(one, rank, y) return above(one, rank, y, 1.7, 0.16) end)
else
  foot = draw_panels(of_article { 'grn-te-neat', 'grn-te-ns', 'grn-aq-neat', 'grn-aq-ns' }, function(one, rank, y) return beside(one, rank, y, 1.15, 0.14) end)
end
on:save(foot)
