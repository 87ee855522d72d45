-- SPDX-License-Identifier: MIT
-- refused: too many instructions
while true do pcall(function() while true do end end) end
