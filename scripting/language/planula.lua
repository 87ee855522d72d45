-- SPDX-License-Identifier: MIT
-- The functions of `planula` that every experiment file may use, loaded before it. `planula.parameters` (the standard
-- value of each parameter) and `planula.locate` (keeps which line of the script made a table, for error messages) come
-- from C++. Nothing here is about the paper: that is experiments/paper/.

local function is_list(value)
  return #value > 0
end

local function is_record(value)
  return type(value) == "table" and not is_list(value)
end

local function need_table(value, name)
  if type(value) ~= "table" then
    error(name .. " takes a table, got " .. type(value), 3)
  end
end

-- The statement, with the defaults for the keys that it does not have; no value is merged.
local function fill(statement, defaults)
  local result = {}
  for key, value in pairs(defaults) do result[key] = value end
  for key, value in pairs(statement) do result[key] = value end
  return result
end

-- The base with some values changed: records (drag = {normal = …}) are changed field by field, lists are replaced.
local function change(base, changes)
  local result = {}
  for key, value in pairs(base) do result[key] = value end
  for key, value in pairs(changes) do
    if is_record(value) and is_record(result[key]) then value = change(result[key], value) end
    result[key] = value
  end
  return result
end

function planula.fill(statement, defaults)
  need_table(statement, "planula.fill")
  need_table(defaults, "planula.fill")
  return planula.locate(fill(statement, defaults))
end

function planula.change(base, changes)
  need_table(base, "planula.change")
  need_table(changes, "planula.change")
  return planula.locate(change(base, changes))
end

-- What a script returns: one setting, or several under `settings`.
function planula.experiment(statement)
  need_table(statement, "planula.experiment")
  return planula.locate(statement)
end
