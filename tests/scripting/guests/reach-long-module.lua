-- SPDX-License-Identifier: MIT
-- refused: a module's name consists of
require(("a"):rep(5e6))
