# SPDX-License-Identifier: MIT
# Figures 3 and 4 of the original: the best individuals with oscillators.
load 'paper/figures/morphologies.gp'
