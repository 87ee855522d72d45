-- SPDX-License-Identifier: MIT
return require "hostile.itself"
