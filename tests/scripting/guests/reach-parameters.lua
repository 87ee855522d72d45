-- SPDX-License-Identifier: MIT
-- refused: planula.parameters.gravity cannot be changed
planula.parameters.gravity = 1
