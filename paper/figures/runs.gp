# SPDX-License-Identifier: MIT
# A number of every run, one small ring each; the panels of series.gp stand side by side. With a table of means, a dot and a
# bar for the mean and its bootstrap interval, else for the median and the quartiles. Given: measure, a column of runs.csv;
# means, a table or nothing; axis, the label of the numbers.
key_room = 14
load 'paper/figures/series.gp'
height = 6.4 + key_height
load 'paper/figures/style.gp'

most = 1
do for [p = 1:|panel|] { most = max(most, words(members[p])) }
set margins screen 0.085, screen 0.985, screen 0.64 / height, screen 1 - (0.64 + key_height) / height
set xrange [-0.6:|panel| - 0.4]
set yrange [*:*]
set offsets 0, 0, graph 0.06, graph 0.06
unset xtics
# As labels, since a per cent sign in a tic's text is a format.
do for [p = 1:|panel|] { set label panel_name(p) at p - 1, screen 0.3 / height center textcolor rgb ink }
set ylabel axis offset 0.8,0 textcolor rgb ink
unset key
load 'paper/figures/key.gp'

# Places along x, those of a panel in the order of its settings; rings of neighbouring seeds stand a little apart.
apart = min(0.32, 0.8 / most)
place(p, i) = p - 1 + apart * (i - (words(members[p]) + 1) / 2.0)
array middle[|setting|]
array low[|setting|]
array high[|setting|]
do for [p = 1:|panel|] { do for [i = 1:words(members[p])] {
    k = member(p, i)
    if (rows_of('runs', setting[k]) == 0) { set label 'no data' at place(p, i), graph 0.5 center rotate font ',7' textcolor rgb tint(k) }
    middle[k] = NaN
    low[k] = NaN
    high[k] = NaN
    if (means eq '' && rows_of('runs', setting[k]) > 0) {
        set yrange [*:*]
        stats table('runs') using (of(setting[k], column(measure))) name 'END' nooutput
        middle[k] = END_median
        if (END_records >= 4) { low[k] = END_lo_quartile; high[k] = END_up_quartile }
    }
}}
# Values that cannot be below 0, as fitness, stand on an axis from 0.
if (means eq '') {
    stats table('runs') using (column(measure)) name 'ALL' nooutput
    if (ALL_records > 0 && ALL_min >= 0) { set yrange [0:*] }
}
source = means eq '' ? 'runs' : means
mean(k, value) = means eq '' ? NaN : of(setting[k], value)
plot for [p = 1:|panel|] for [i = 1:words(members[p])] k = member(p, i) table('runs') \
         using (place(p, i) + (0.34 + 0.05 * (int(column('seed')) % 5 - 2)) * apart):(of(setting[k], column(measure))) \
         with points pointtype 6 pointsize 0.35 linewidth 0.7 linecolor rgb tint(k), \
     for [p = 1:|panel|] for [i = 1:words(members[p])] k = member(p, i) table(source) \
         using (place(p, i)):(mean(k, column('mean'))):(mean(k, column('low'))):(mean(k, column('high'))) \
         with yerrorbars pointtype 0 pointsize 0 linewidth 1.6 linecolor rgb tint(k), \
     for [p = 1:|panel|] for [i = 1:words(members[p])] k = member(p, i) table(source) \
         using (place(p, i)):(mean(k, column('mean'))) with points pointtype 7 pointsize 0.7 linecolor rgb tint(k), \
     for [p = 1:|panel|] for [i = 1:words(members[p])] k = member(p, i) '+' \
         using (place(p, i)):(middle[k]):(low[k]):(high[k]) every ::0::0 with yerrorbars pointtype 0 pointsize 0 linewidth 1.6 linecolor rgb tint(k), \
     for [p = 1:|panel|] for [i = 1:words(members[p])] k = member(p, i) '+' \
         using (place(p, i)):(middle[k]) every ::0::0 with points pointtype 7 pointsize 0.7 linecolor rgb tint(k)
