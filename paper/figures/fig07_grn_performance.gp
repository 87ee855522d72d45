# SPDX-License-Identifier: MIT
# Figure 7 of the original: performance with the gene regulatory network, in water and on land.
panels = '3 4'
panel_name(p) = p % 2 == 1 ? 'water' : 'land'
key_room = 4.6 # the key stands beside such short names
load 'paper/figures/performance.gp'
