# SPDX-License-Identifier: MIT
# Figure 10 of the original: the archive of novelty search with oscillators, in water and on land.
shown = '2 4'
kinds = 'plane line'
title_of(k) = k == 2 ? 'water' : 'land'
load 'paper/figures/archive.gp'
