-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'rawset'
rawset(string, "x", 1)
