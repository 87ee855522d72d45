# SPDX-License-Identifier: MIT
# Figure 11 of the original: distribution of fitness in the last generation, each run relative to the highest of that generation, mean of runs.
height = 5.2
load 'paper/figures/style.gp'

groups = 'osc-aq osc-te grn-aq grn-te'
titles = '"oscillators, water" "oscillators, land" "GRN, water" "GRN, land"'
stats table('fitness_shares') using (100 * column('share')) name 'END' nooutput
set multiplot layout 1,4 margins 0.07,0.985,0.2,0.9 spacing 0.02,0
set xrange [0:1]
set yrange [0:1.05 * largest(100)]
set xtics ('0' 0, '0.5' 0.5, '1' 1)
do for [i = 1:4] {
    group = word(groups, i)
    set label 1 panel_title(word('A B C D', i), word(titles, i)) at graph 0,1.06 left textcolor rgb ink
    set label 2 (i == 1 ? 'fitness relative to the highest of the generation' : '') at screen 0.5275,0.05 center textcolor rgb ink
    set ylabel (i == 1 ? 'individuals (%)' : '') offset 0.2,0 textcolor rgb ink
    if (i == 1) { set format y '%g'; set key top left Left reverse samplen 0.8 } else { set format y ''; unset key }
    plot @unseen, for [search in 'neat ns'] table('fitness_shares') \
             using (of(group.'-'.search, (column('low') + column('high')) / 2)):(100 * column('share')) \
                 :(column('high') - column('low')) \
             with boxes fillstyle transparent solid 0.35 noborder linecolor rgb colour(search) title name_of(search)
}
unset multiplot
