# SPDX-License-Identifier: MIT
# Figure 9 of the original: exploration on land with oscillators, the best run of each search.
shown = '3 4'
load 'paper/figures/walkers.gp'
