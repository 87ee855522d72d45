# SPDX-License-Identifier: MIT
# Where the individuals of a setting's best run ended along the ground, over the generations: the density of all of them
# (colour) and the best so far (line). Given: shown, settings of series.gp.
load 'paper/figures/series.gp'
rows = (words(shown) + 1) / 2
height = 0.6 + 6.4 * rows
load 'paper/figures/style.gp'
if (!exists("GPFUN_title_of")) title_of(k) = label(k)

last = last_of('generations')
names = ' '
do for [n = 1:words(shown)] { names = names.setting[int(word(shown, n))].' ' }
walker(value) = strstrt(names, ' '.stringcolumn('setting').' ') > 0 && stringcolumn('role') eq 'best' ? value : NaN
reach = 1
stats table('endpoint_paths') using (walker(abs(column('x')))) name 'END' nooutput
reach = max(reach, largest(reach))
undefine END_*
stats table('endpoint_density') using (walker(max(abs(column('x_low')), abs(column('x_high'))))) name 'END' nooutput
reach = 1.02 * max(reach, largest(reach))
# The individuals of a bin for each of its generations and cell diameters.
density(count) = count / (column('generation_high') - column('generation_low') + 1) / (column('x_high') - column('x_low'))
undefine END_*
stats table('endpoint_density') using (walker(density(column('individuals')))) name 'END' nooutput
most = largest(1)
least = min(lowest(0.1), most / 10)

set multiplot
set xrange [-0.5:last + 0.5]
set yrange [-reach:reach]
set xtics 0, generation_tics(last)
set xzeroaxis linewidth 0.6 linecolor rgb 0x999999
unset grid
unset key
set palette defined (0 '#e3edf7', 0.35 '#9ecae1', 0.65 '#4292c6', 1 '#08306b')
set logscale cb
set cbrange [least:most]
set format cb '%g'
do for [n = 1:words(shown)] {
    k = int(word(shown, n))
    at = (n - 1) % 2
    row = (n - 1) / 2
    set lmargin at screen 0.075 + at * 0.425
    set rmargin at screen 0.465 + at * 0.425
    set tmargin at screen 1 - (0.595 + 6.4 * row) / height
    set bmargin at screen 1 - (5.95 + 6.4 * row) / height
    set label 1 panel_title(words(shown) > 1 ? letter(n) : '', title_of(k)) at graph 0,1.06 left textcolor rgb ink
    set label 2 lacks('endpoint_paths', setting[k]) at graph 0.5,0.5 center textcolor rgb 0x777777
    set ylabel (at == 0 ? 'x at the end (cell diameters)' : '') offset 0.8,0 textcolor rgb ink
    is_lowest = n + 2 > words(shown)
    set xlabel (is_lowest ? 'generation' : '') offset 0,0.9 textcolor rgb ink
    if (is_lowest) { set format x '%g' } else { set format x '' }
    if (at == 0) { set format y '%g' } else { set format y '' }
    if (n == words(shown)) {
        set colorbox user origin 0.915,1.4 / height size 0.014,4.62 / height noborder
        set cblabel 'individuals per generation and cell diameter' offset 0.5,0 font ',7' textcolor rgb ink
    } else { unset colorbox }
    of_run(value) = stringcolumn('role') eq 'best' ? of(setting[k], value) : NaN
    # The x of the fittest so far, row by row.
    highest = -1
    place = NaN
    best_so_far(fitness, x) = fitness > highest ? (highest = fitness, place = x) : place
    plot @unseen, table('endpoint_density') using (of_run((column('generation_low') + column('generation_high')) / 2)) \
             :((column('x_low') + column('x_high')) / 2):(column('generation_low') - 0.5):(column('generation_high') + 0.5) \
             :(column('x_low')):(column('x_high')):(density(column('individuals'))) with boxxyerror fillcolor palette, \
         table('endpoint_paths') using (of_run(column('generation'))) \
             :(of_run(1) == 1 ? best_so_far(column('fitness'), column('x')) : NaN) \
             with steps linewidth 1.5 linecolor rgb 0xCC1F1A
}
unset multiplot
