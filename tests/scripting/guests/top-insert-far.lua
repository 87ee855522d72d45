-- SPDX-License-Identifier: MIT
-- refused: table.insert: the list has no place 1e+15
local t = {}
table.insert(t, 1e15, 1)
