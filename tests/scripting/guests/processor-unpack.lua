-- SPDX-License-Identifier: MIT
-- refused: unpack: argument 3 is
local s = unpack({ 1 }, 1, 1e10)
