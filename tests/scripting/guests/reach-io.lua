-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'io'
io.open("x", "w")
