-- SPDX-License-Identifier: MIT
-- refused: 'total' is not local
total = 1
return {}
