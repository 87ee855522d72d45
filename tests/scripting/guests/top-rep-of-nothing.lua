-- SPDX-License-Identifier: MIT
-- refused: not a number of
local s = (""):rep(1e15)
