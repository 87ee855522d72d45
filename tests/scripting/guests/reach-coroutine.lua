-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'coroutine'
coroutine.create(function() end)
