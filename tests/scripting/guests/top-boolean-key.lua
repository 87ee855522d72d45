-- SPDX-License-Identifier: MIT
-- refused: a key of type boolean
return { [true] = 1 }
