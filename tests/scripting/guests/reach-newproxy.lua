-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'newproxy'
newproxy(true)
