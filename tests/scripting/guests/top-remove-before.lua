-- SPDX-License-Identifier: MIT
-- refused: the list has no place -2147483648
local t = { 1 }
table.remove(t, -2147483648)
