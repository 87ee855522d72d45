-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'load'
load("return 1")()
