# SPDX-License-Identifier: MIT
# Figure 8 of the original: exploration in water with oscillators, the best and the median run of each search.
shown = '1 1 2 2'
roles = 'best median best median'
load 'paper/figures/exploration.gp'
