# SPDX-License-Identifier: MIT
# Heredity of fitness over the generations. Not in the original.
load 'paper/figures/heredity.gp'
