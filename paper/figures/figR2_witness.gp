# SPDX-License-Identifier: MIT
# The champions simulated again: change of their displacement at half the time step (rings) and in Bullet (dots), over the
# displacement in our engine. The dashed line is the bound beyond which a difference needs a cause. Not in the original.
height = 5.8
load 'paper/figures/style.gp'

groups = 'osc-aq osc-te grn-aq grn-te'
titles = '"oscillators, water" "oscillators, land" "GRN, water" "GRN, land"'
bound = 100 * system("awk -F, '$2 == \"exploit_bound\" { print $4 }' '".table('parameters')."'")
least = 0.001 # per cent; smaller changes are drawn there
change(value) = max(least, 100 * value)
set multiplot layout 1,4 margins 0.085,0.985,0.17,0.83 spacing 0.02,0
set xlabel 'displacement' offset 0,0.9 textcolor rgb ink
unset key
do for [k = 1:2] {
    x = k == 1 ? 0.56 : 0.66
    set label name_of(word('neat ns', k)) at screen x,0.955 left textcolor rgb colour(word('neat ns', k))
}
set label 'half the step' at screen 0.10,0.955 left textcolor rgb ink point pointtype 6 pointsize 0.6 linecolor rgb ink offset 0.8,0
set label 'Bullet' at screen 0.24,0.955 left textcolor rgb ink point pointtype 7 pointsize 0.6 linecolor rgb ink offset 0.8,0
do for [i = 1:4] {
    group = word(groups, i)
    set label panel_title(word('A B C D', i), word(titles, i)) at graph 0,1.07 left textcolor rgb ink
    set label lacks('witness', group.'-neat').lacks('witness', group.'-ns') at graph 0.5,0.5 center font ',7' textcolor rgb 0x777777
    set ylabel (i == 1 ? 'change of displacement (%)' : '') offset 0.4,0 textcolor rgb ink
    undefine END_*
    unset logscale
    set yrange [*:*]
    stats table('witness') using (strstrt(stringcolumn('setting'), group) == 1 ? column('displacement') : NaN) name 'END' nooutput
    set xrange [0:1.06 * largest(1)]
    set xtics 0, step_of(largest(2) / 4.0)
    set logscale y
    set yrange [0.7 * least:200]
    if (i == 1) { set ytics ('≤ 0.001' 0.001, '0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10, '100' 100) } else { set ytics ('' 0.001, '' 0.01, '' 0.1, '' 1, '' 10, '' 100) }
    plot @unseen, bound with lines linewidth 0.8 dashtype 2 linecolor rgb 0x777777, \
         for [search in 'neat ns'] table('witness') using (of(group.'-'.search, column('displacement'))):(change(column('half_change'))) \
             with points pointtype 6 pointsize 0.5 linewidth 0.9 linecolor rgb colour(search), \
         for [search in 'neat ns'] table('witness') using (of(group.'-'.search, column('displacement'))):(change(column('bullet_change'))) \
             with points pointtype 7 pointsize 0.45 linecolor rgb colour(search)
    unset label
}
unset multiplot
