-- SPDX-License-Identifier: MIT
-- How a finished life is judged (§2.7): the only home of Eqs. (4) and (6) and of the descriptor. A life is
-- {outcome, cells, largest, births, springs, triangles, elongation, settle_steps, late_actuation, rest = {x, y},
-- finish = {x, y}, activity, displacement, path = {{x, y}, …}}; parameters are those of the setting.

-- Eq. (6): p. Every outcome but "viable" is one of its zeros: no cell left, fewer than minimum_cells,
-- cell_limit reached even once, never at rest; "exploded" (the simulation broke down) is ours.
local function penalty(life, parameters)
  if life.outcome ~= "viable" then return 0 end
  if life.births >= parameters.birth_limit then return parameters.birth_penalty end
  return 1
end

-- Eq. (4): the displacement of the centre of mass from where it came to rest to where it ended, and the
-- actuation bonus b_a of Eq. (5), which is 0 with oscillators.
local function fitness(life, parameters, p)
  local dx = life.finish.x - life.rest.x
  local dy = life.finish.y - life.rest.y
  return (math.sqrt(dx * dx + dy * dy) + parameters.activity_bonus * life.activity) * p
end

-- §2.7.2: the final coordinates of the centre of mass.
local function behaviour(life)
  return { life.finish.x, life.finish.y }
end

return { penalty = penalty, fitness = fitness, behaviour = behaviour }
