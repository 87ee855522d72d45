-- SPDX-License-Identifier: MIT
-- refused: random numbers are not allowed
local x = math.random()
