-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'loadstring'
loadstring("return 1")()
