-- SPDX-License-Identifier: MIT
-- refused: select: argument 1 is
local s = select(1e10, 1, 2)
