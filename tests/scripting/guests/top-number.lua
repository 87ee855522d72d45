-- SPDX-License-Identifier: MIT
-- refused: must return planula.experiment
return 5
