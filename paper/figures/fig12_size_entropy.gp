# SPDX-License-Identifier: MIT
# Figure 12 of the original: Shannon entropy (Eq. 8) of the body sizes of a run. One small ring per run, a dot and a bar for
# the mean and its bootstrap interval.
height = 6.4
load 'paper/figures/style.gp'

set margins screen 0.085, screen 0.985, screen 0.10, screen 0.90
set xrange [-0.6:3.6]
set yrange [*:*]
set offsets 0, 0, graph 0.06, graph 0.06
set xtics scale 0 offset 0,0.2 ('oscillators, water' 0, 'oscillators, land' 1, 'GRN, water' 2, 'GRN, land' 3)
set ylabel 'entropy of body sizes (nats)' offset 0.8,0 textcolor rgb ink
set key at screen 0.985,0.99 top right horizontal Left reverse samplen 0.5 width -2

# Places of the four groups along x; NEAT stands left of the middle, novelty search right.
groups = 'osc-aq osc-te grn-aq grn-te'
place(i, search) = i - 1 + (search eq 'neat' ? -0.16 : 0.16)
do for [i = 1:4] { do for [search in 'neat ns'] {
    if (rows_of('entropy', word(groups, i).'-'.search) == 0) {
        set label 'no data' at place(i, search), graph 0.5 center rotate font ',7' textcolor rgb colour(search)
    }
}}
plot for [search in 'neat ns'] for [i = 1:4] setting = word(groups, i).'-'.search table('runs') \
         using (place(i, search) + 0.09):(of(setting, column('size_entropy'))) \
         with points pointtype 6 pointsize 0.35 linewidth 0.7 linecolor rgb colour(search) notitle, \
     for [search in 'neat ns'] for [i = 1:4] setting = word(groups, i).'-'.search table('entropy') \
         using (place(i, search)):(of(setting, column('mean'))):(column('low')):(column('high')) \
         with yerrorbars pointtype 0 pointsize 0 linewidth 1.6 linecolor rgb colour(search) notitle, \
     for [search in 'neat ns'] for [i = 1:4] setting = word(groups, i).'-'.search table('entropy') \
         using (place(i, search)):(of(setting, column('mean'))) \
         with points pointtype 7 pointsize 0.7 linecolor rgb colour(search) title (i == 1 ? name_of(search) : '')
