-- SPDX-License-Identifier: MIT
-- refused: title must be one line
local paper = require "paper"
return paper.experiment {
  name = "guest",
  title = "two\rlines",
}
