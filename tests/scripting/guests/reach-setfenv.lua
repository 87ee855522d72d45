-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'setfenv'
setfenv(1, {})
