-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'rawget'
rawget(string, "x")
