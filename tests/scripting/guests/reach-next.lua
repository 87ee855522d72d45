-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'next'
next({})
