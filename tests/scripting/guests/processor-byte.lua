-- SPDX-License-Identifier: MIT
-- refused: string.byte: argument 2 is nan
local s = ("abc"):byte(0 / 0)
