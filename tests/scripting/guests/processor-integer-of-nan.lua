-- SPDX-License-Identifier: MIT
-- refused: %d cannot show nan
local s = string.format("%d", 0 / 0)
