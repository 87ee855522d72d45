# SPDX-License-Identifier: MIT
# Figure 12 of the original: Shannon entropy (Eq. 8) of the body sizes of a run.
measure = 'size_entropy'
means = 'entropy'
axis = 'entropy of body sizes (nats)'
load 'paper/figures/runs.gp'
