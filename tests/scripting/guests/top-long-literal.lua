-- SPDX-License-Identifier: MIT
-- refused: a number of the FFI
local n = 1LL
return {}
