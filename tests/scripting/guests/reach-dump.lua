-- SPDX-License-Identifier: MIT
-- refused: string has no 'dump'
string.dump(function() end)
