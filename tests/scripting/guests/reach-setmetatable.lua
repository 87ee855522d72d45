-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'setmetatable'
setmetatable({}, {})
