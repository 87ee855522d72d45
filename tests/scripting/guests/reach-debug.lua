-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'debug'
debug.getregistry()
