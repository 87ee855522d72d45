-- SPDX-License-Identifier: MIT
-- refused: hostile/endless.lua:2: the script executes too many instructions
require "hostile.endless"
