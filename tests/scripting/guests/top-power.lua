-- SPDX-License-Identifier: MIT
-- refused: ^
local n = 2 ^ 0.5
return {}
