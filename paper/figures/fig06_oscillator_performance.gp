# SPDX-License-Identifier: MIT
# Figure 6 of the original: performance with oscillators.
actuation = 'osc'
load 'paper/figures/performance.gp'
