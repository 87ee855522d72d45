-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'getmetatable'
getmetatable("")
