-- SPDX-License-Identifier: MIT
-- refused: string.sub: argument 2 is 1e+10
local s = ("abc"):sub(1e10)
