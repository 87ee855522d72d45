-- SPDX-License-Identifier: MIT
-- refused: must return planula.experiment
local paper = require "paper"
