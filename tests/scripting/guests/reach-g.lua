-- SPDX-License-Identifier: MIT
-- refused: nothing is called '_G'
local x = _G.string
