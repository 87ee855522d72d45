-- SPDX-License-Identifier: MIT
-- refused: %p shows an address
local s = string.format("\0%p", "x")
