-- SPDX-License-Identifier: MIT
-- refused: table.concat: argument 3 is
local s = table.concat({ "a" }, "", -1e10)
