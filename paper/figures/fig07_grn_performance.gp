# SPDX-License-Identifier: MIT
# Figure 7 of the original: performance with the gene regulatory network.
actuation = 'grn'
load 'paper/figures/performance.gp'
