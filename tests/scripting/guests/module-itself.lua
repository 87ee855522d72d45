-- SPDX-License-Identifier: MIT
-- refused: requires itself
require "hostile.itself"
