-- SPDX-License-Identifier: MIT
-- refused: xxxx
error(("x"):rep(5e6))
