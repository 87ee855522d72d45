-- SPDX-License-Identifier: MIT
-- The paper's experiment with another engine: the same bodies, forces and searches, with the integration and ground
-- contact of Bullet. `planula witness` simulates its champions in the native engine too.
local replication = require "paper.replication"

local settings = {}
for index, setting in ipairs(replication.settings) do
  settings[index] = planula.change(setting, { engine = "bullet" })
end

return planula.fill({ name = "engines", title = "The paper's settings in Bullet", settings = settings }, replication)
