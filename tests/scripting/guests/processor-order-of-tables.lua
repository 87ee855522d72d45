-- SPDX-License-Identifier: MIT
-- refused: keys of type table have no order
for key in pairs { [{}] = 1 } do end
