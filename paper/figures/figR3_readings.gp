# SPDX-License-Identifier: MIT
# Best fitness of every run under each reading of the original (experiments/readings.lua). One small ring per run, a dot for
# the median. The readings stand from top to bottom, named as in paper/readings.lua. Not in the original.
height = 7.6
load 'paper/figures/style.gp'

groups = 'osc-aq osc-te grn-aq grn-te'
titles = '"oscillators, water" "oscillators, land" "GRN, water" "GRN, land"'
readings = 'standard earlier both-turn daughters plane range-1 range-025 clearance start-1 power-1 rising present aged'
names = '"standard" "earlier standard" "both turn" "daughter turns" "plane" "range 1" "range 0.25" "clearance 0.75" ' \
        .'"start weights 1" "mutations 1" "time rises" "present place" "aged species"'
count = words(readings)

# Places from top to bottom, a little more between the groups of the tables; NEAT stands above novelty search.
gap(i) = i <= 2 ? 0 : i <= 8 ? 0.5 : i <= 10 ? 1 : 1.5
place(i, search) = -i - gap(i) + (search eq 'neat' ? 0.17 : -0.17)

# The median of the runs of a setting, NaN without any.
array middle[8 * count]
do for [i = 1:count] { do for [g = 1:4] { do for [s = 1:2] {
    undefine END_*
    stats table('readings') using (of(word(readings, i).'-'.word(groups, g).'-'.word('neat ns', s), column('best_fitness'))) name 'END' nooutput
    middle[8 * (i - 1) + 2 * (g - 1) + s] = exists('END_median') && found(0) > 0 ? END_median : NaN
}}}

set multiplot layout 1,4 margins 0.155,0.985,0.125,0.875 spacing 0.03,0
set grid noytics xtics linewidth 0.5 linecolor rgb pale dashtype 1
set border 1
unset key
do for [k = 1:2] {
    search = word('neat ns', k)
    x = search eq 'neat' ? 0.715 : 0.82
    set label name_of(search) at screen x + 0.018,0.968 left textcolor rgb ink point pointtype 7 pointsize 0.6 linecolor rgb colour(search) offset 0.8,0
}
do for [g = 1:4] {
    if (g > 1) { unset ytics } else {
        set ytics scale 0 offset 0.4,0 (word(names, 1) -1)
        do for [i = 2:count] { set ytics add (word(names, i) -i - gap(i)) }
    }
    undefine END_*
    set yrange [*:*]
    stats table('readings') using (strstrt(stringcolumn('setting'), '-'.word(groups, g).'-') > 0 ? column('best_fitness') : NaN) name 'END' nooutput
    set xrange [0:1.04 * largest(1)]
    set yrange [-count - gap(count) - 0.7:-0.3]
    set xtics 0, step_of(largest(2) / 4.0)
    set xlabel 'best fitness' offset 0,0.9 textcolor rgb ink
    set label panel_title(word('A B C D', g), word(titles, g)) at graph 0,1.06 left textcolor rgb ink
    plot @unseen, for [s = 1:2] for [i = 1:count] table('readings') \
             using (of(word(readings, i).'-'.word(groups, g).'-'.word('neat ns', s), column('best_fitness'))):(place(i, word('neat ns', s))) \
             with points pointtype 6 pointsize 0.4 linewidth 0.7 linecolor rgb colour(word('neat ns', s)), \
         for [s = 1:2] for [i = 1:count] '+' using (middle[8 * (i - 1) + 2 * (g - 1) + s]):(place(i, word('neat ns', s))) every ::0::0 \
             with points pointtype 7 pointsize 0.6 linecolor rgb colour(word('neat ns', s))
    unset label
}
unset multiplot
