-- SPDX-License-Identifier: MIT
-- refused: unexpected symbol near
return {
