-- SPDX-License-Identifier: MIT
-- refused: without a gap
return { settings = { [1] = {}, [3] = {} } }
