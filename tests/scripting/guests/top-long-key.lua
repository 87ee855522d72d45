-- SPDX-License-Identifier: MIT
-- refused: the experiment has no 'kkkk
local key = ("k"):rep(2e6)
return planula.experiment { [key] = 1 }
