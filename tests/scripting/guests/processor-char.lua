-- SPDX-License-Identifier: MIT
-- refused: string.char: argument 1 is nan
local s = string.char(0 / 0)
