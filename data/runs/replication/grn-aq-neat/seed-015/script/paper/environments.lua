-- SPDX-License-Identifier: MIT
-- The two worlds of the paper (§2.5). A text in place of a number names the parameter that holds it, so that
-- changing the parameter changes the world; `planula parameters` lists them all.
return {
  -- Water: no gravity, a fluid at rest that drags on the outline of the body.
  aquatic = {
    drag = { normal = "drag_normal", tangential = "drag_tangential" },
    actuation_range = "actuation_range_aquatic",
  },

  -- Land: gravity, and friction between the cells and a flat ground.
  terrestrial = {
    gravity = "gravity",
    ground = "flat",
    friction = "friction",
    actuation_range = "actuation_range_terrestrial",
  },
}
