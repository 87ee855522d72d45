-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'bit'
bit.band(1, 2)
