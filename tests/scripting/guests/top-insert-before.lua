-- SPDX-License-Identifier: MIT
-- refused: the list has no place -2147483648
local t = {}
table.insert(t, -2147483648, 1)
