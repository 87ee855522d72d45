-- SPDX-License-Identifier: MIT
-- refused: must return a table
require "hostile.number"
