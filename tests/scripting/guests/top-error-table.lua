-- SPDX-License-Identifier: MIT
-- refused: an error that is not a text
error({})
