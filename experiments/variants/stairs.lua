-- SPDX-License-Identifier: MIT
-- Does novelty search lead animats up stairs, since it rewards places where no animat ended before? The ground is
-- stated by points {x, y} from left to right; beyond the first and the last it is level. Bodies start around x = 0.
local paper = require "paper"

return paper.experiment {
  name = "stairs",
  title = "Stairs on both sides",
  search = "novelty",
  environment = paper.terrestrial {
    ground = {
      { -60, 3 }, { -40.1, 3 }, { -40, 2 }, { -25.1, 2 }, { -25, 1 }, { -15.1, 1 }, { -15, 0 },
      { 15, 0 }, { 15.1, 1 }, { 25, 1 }, { 25.1, 2 }, { 40, 2 }, { 40.1, 3 }, { 60, 3 },
    },
  },
}
