-- SPDX-License-Identifier: MIT
-- refused: string has no 'gsub'
("x"):gsub("x", "y")
