-- SPDX-License-Identifier: MIT
-- refused: is too long
local s = ("x"):rep(2e9)
