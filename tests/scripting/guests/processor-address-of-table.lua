-- SPDX-License-Identifier: MIT
-- refused: takes texts and numbers, got table
local s = string.format("%s", {})
