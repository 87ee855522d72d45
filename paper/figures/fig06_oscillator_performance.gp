# SPDX-License-Identifier: MIT
# Figure 6 of the original: performance with oscillators, in water and on land.
panels = '1 2'
panel_name(p) = p % 2 == 1 ? 'water' : 'land'
key_room = 4.6 # the key stands beside such short names
load 'paper/figures/performance.gp'
