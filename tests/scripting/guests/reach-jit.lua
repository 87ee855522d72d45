-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'jit'
jit.on()
