-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'print'
print("x")
