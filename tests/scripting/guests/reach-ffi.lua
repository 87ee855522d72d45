-- SPDX-License-Identifier: MIT
-- refused: no module 'ffi'
require("ffi")
