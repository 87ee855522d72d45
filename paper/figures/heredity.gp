# SPDX-License-Identifier: MIT
# Heredity of fitness over the generations: medians of the runs. Rows: mother-offspring correlation; offspring near their
# mother; individuals near the best. A column for each panel of series.gp.
key_room = 9
load 'paper/figures/series.gp'
height = 11.5 + key_height
load 'paper/figures/style.gp'

measures = 'heredity_fitness near_mother near_best'
labels = '"correlation" "near mother (%)" "near best (%)"'
last = last_of('generations')
set multiplot layout 3,|panel| margins 0.085,0.985,0.98 / height,1 - (1.21 + key_height) / height spacing 0.02,0.52 / height
set xrange [0:last]
set xtics 0, (|panel| > 4 ? 2 : 1) * generation_tics(last)
unset key

load 'paper/figures/key.gp'
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
    do for [p = 1:|panel|] {
        missing = ''
        do for [i = 1:words(members[p])] { missing = missing.lacks('heredity', setting[member(p, i)]) }
        if (row == 1) { set label panel_title(|panel| > 1 ? letter(p) : '', panel_name(p)) at graph 0,1.1 left textcolor rgb ink }
        set label missing at graph 0.5,0.5 center font ',7' textcolor rgb 0x777777
        set ylabel (p == 1 ? word(labels, row) : '') offset 0.8,0 textcolor rgb ink
        set xlabel (row == 3 ? 'generation' : '') offset 0,0.9 textcolor rgb ink
        if (p == 1) { set format y '%g' } else { set format y '' }
        if (row == 3) { set format x '%g' } else { set format x '' }
        plot @unseen, for [i = 1:words(members[p])] k = member(p, i) table('heredity') \
                 using (of(setting[k], column('generation'))):(percent(column(measure))) \
                 with linespoints linewidth 1.4 pointtype symbol(series_of[k]) pointsize 0.4 pointinterval generation_tics(last) linecolor rgb tint(k)
        unset arrow
        unset label
    }
}
unset multiplot
