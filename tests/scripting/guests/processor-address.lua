-- SPDX-License-Identifier: MIT
-- refused: %p shows an address
local s = string.format("%p", "x")
