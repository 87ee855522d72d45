-- SPDX-License-Identifier: MIT
-- refused: takes texts and numbers, got function
local s = string.format("%s", function() end)
