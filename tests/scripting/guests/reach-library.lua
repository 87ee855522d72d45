-- SPDX-License-Identifier: MIT
-- refused: string.format cannot be changed
string.format = nil
