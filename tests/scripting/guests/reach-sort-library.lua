-- SPDX-License-Identifier: MIT
-- refused: a read-only table cannot be changed
table.sort(math)
