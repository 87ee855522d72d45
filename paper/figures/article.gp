# SPDX-License-Identifier: MIT
# The settings of the article, for series.gp: a panel for each actuation and world, a series for each search.
array setting[8] = ['osc-aq-neat', 'osc-aq-ns', 'osc-te-neat', 'osc-te-ns', 'grn-aq-neat', 'grn-aq-ns', 'grn-te-neat', 'grn-te-ns']
array series_of[8] = [1, 2, 1, 2, 1, 2, 1, 2]
array series[2] = ['NEAT', 'novelty search']
array hue[2] = [0x0072B2, 0xD55E00]
array panel[4] = ['oscillators, water', 'oscillators, land', 'GRN, water', 'GRN, land']
array members[4] = ['1 2', '3 4', '5 6', '7 8']
fitness_label = 'best fitness (cell diameters)'
