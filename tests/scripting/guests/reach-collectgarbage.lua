-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'collectgarbage'
collectgarbage()
