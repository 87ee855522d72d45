-- SPDX-License-Identifier: MIT
-- refused: a module's name consists of
require "../../secret"
