# SPDX-License-Identifier: MIT
# Figure 5 of the original: the best individuals with the gene regulatory network.
load 'paper/figures/morphologies.gp'
