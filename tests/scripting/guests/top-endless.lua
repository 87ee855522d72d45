-- SPDX-License-Identifier: MIT
-- refused: too many instructions
while true do end
