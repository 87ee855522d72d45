-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'dofile'
dofile("/etc/passwd")
