# SPDX-License-Identifier: MIT
# Heredity of fitness over the generations: medians of the runs. Rows: mother-offspring correlation; offspring near their
# mother; individuals near the best. Columns: actuation and world. Not in the original.
height = 11.5
load 'paper/figures/style.gp'

groups = 'osc-aq osc-te grn-aq grn-te'
titles = '"oscillators, water" "oscillators, land" "GRN, water" "GRN, land"'
measures = 'heredity_fitness near_mother near_best'
labels = '"correlation" "near mother (%)" "near best (%)"'
last = last_of('generations')
set multiplot layout 3,4 margins 0.07,0.985,0.085,0.895 spacing 0.02,0.045
set xrange [0:last]
set xtics 0, generation_tics(last)
unset key

# A key above the panels, drawn with the first of them.
do for [search in 'neat ns'] {
    x = search eq 'neat' ? 0.715 : 0.82
    set arrow from screen x,0.972 to screen x + 0.03,0.972 nohead linewidth 1.4 linecolor rgb colour(search)
    set label name_of(search) at screen x + 0.037,0.972 left textcolor rgb ink
}
do for [row = 1:3] {
    measure = word(measures, row)
    percent(value) = row == 1 ? value : 100 * value
    # The same range in all columns; a correlation needs room below 0.
    undefine END_*
    set yrange [*:*]
    stats table('heredity') using (percent(column(measure))) name 'END' nooutput
    top = 1.08 * max(largest(1), row == 1 ? 0.3 : 1)
    set yrange [(row == 1 ? min(-0.1, 1.08 * lowest(0)) : 0):top]
    if (row == 1) { set xzeroaxis linewidth 0.6 linecolor rgb 0x999999 } else { unset xzeroaxis }
    do for [i = 1:4] {
        group = word(groups, i)
        if (row == 1) { set label panel_title(word('A B C D', i), word(titles, i)) at graph 0,1.1 left textcolor rgb ink }
        set label lacks('heredity', group.'-neat').lacks('heredity', group.'-ns') at graph 0.5,0.5 center font ',7' textcolor rgb 0x777777
        set ylabel (i == 1 ? word(labels, row) : '') offset 0.8,0 textcolor rgb ink
        set xlabel (row == 3 ? 'generation' : '') offset 0,0.9 textcolor rgb ink
        if (i == 1) { set format y '%g' } else { set format y '' }
        if (row == 3) { set format x '%g' } else { set format x '' }
        plot @unseen, for [search in 'neat ns'] table('heredity') \
                 using (of(group.'-'.search, column('generation'))):(percent(column(measure))) \
                 with lines linewidth 1.4 linecolor rgb colour(search)
        unset arrow
        unset label
    }
}
unset multiplot
