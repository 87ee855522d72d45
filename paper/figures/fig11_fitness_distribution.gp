# SPDX-License-Identifier: MIT
# Figure 11 of the original: distribution of fitness. The original describes the lower rows.
load 'paper/figures/distribution.gp'
