-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'getfenv'
getfenv(1)
