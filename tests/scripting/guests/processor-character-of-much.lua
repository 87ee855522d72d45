-- SPDX-License-Identifier: MIT
-- refused: %c cannot show
local s = string.format("%c", 1e10)
