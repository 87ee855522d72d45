# SPDX-License-Identifier: MIT
# Figure 9 of the original: where walkers with oscillators ended, over the generations, in the best run of each search. A
# random share of all individuals (points; dark where many are) and the best individual so far (line).
height = 6.6
load 'paper/figures/style.gp'

last = manifest('generations') > 1 ? manifest('generations') - 1 : 1
walker(value) = strstrt(stringcolumn('setting'), '-te-') > 0 && stringcolumn('role') eq 'best' ? value : NaN
reach = 1
do for [name in 'endpoint_paths endpoints'] {
    stats table(name) using (walker(abs(column('x')))) name 'END' nooutput
    reach = max(reach, largest(reach))
}
reach = 1.05 * reach
set multiplot layout 1,2 margins 0.075,0.985,0.165,0.915 spacing 0.08,0
set xrange [0:last]
set yrange [-reach:reach]
set xtics 0, generation_tics(last)
set xlabel 'generation' offset 0,0.9 textcolor rgb ink
set xzeroaxis linewidth 0.6 linecolor rgb 0x999999
unset key
do for [search in 'neat ns'] {
    setting = 'osc-te-'.search
    set label 1 panel_title(search eq 'neat' ? 'A' : 'B', name_of(search)) at graph 0,1.06 left textcolor rgb ink
    set ylabel (search eq 'neat' ? 'x at the end (cell diameters)' : '') offset 0.8,0 textcolor rgb ink
    of_run(value) = stringcolumn('role') eq 'best' ? of(setting, value) : NaN
    # The x of the fittest so far, row by row.
    highest = -1
    place = NaN
    best_so_far(fitness, x) = fitness > highest ? (highest = fitness, place = x) : place
    plot @unseen, table('endpoints') using (of_run(column('generation'))):(column('x')) \
             with points pointtype 7 pointsize (found(0) < 4000 ? 0.35 : 0.2) linecolor rgb 0xB0123A6B, \
         table('endpoint_paths') using (of_run(column('generation'))) \
             :(of_run(1) == 1 ? best_so_far(column('fitness'), column('x')) : NaN) \
             with steps linewidth 1.4 linecolor rgb 0xCC1F1A
}
unset multiplot
