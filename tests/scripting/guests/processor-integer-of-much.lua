-- SPDX-License-Identifier: MIT
-- refused: %x cannot show 1e+30
local s = string.format("%x", 1e30)
