# SPDX-License-Identifier: MIT
# Figure 9 of the original: where walkers with oscillators ended, over the generations, in the best run of each search. The
# density of all individuals (colour) and the best individual so far (line).
height = 7.0
load 'paper/figures/style.gp'

last = last_of('generations')
walker(value) = strstrt(stringcolumn('setting'), '-te-') > 0 && stringcolumn('role') eq 'best' ? value : NaN
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
set xlabel 'generation' offset 0,0.9 textcolor rgb ink
set xzeroaxis linewidth 0.6 linecolor rgb 0x999999
unset grid
unset key
set palette defined (0 '#e3edf7', 0.35 '#9ecae1', 0.65 '#4292c6', 1 '#08306b')
set logscale cb
set cbrange [least:most]
set format cb '%g'
do for [search in 'neat ns'] {
    setting = 'osc-te-'.search
    i = search eq 'neat' ? 0 : 1
    set lmargin at screen 0.075 + i * 0.425
    set rmargin at screen 0.465 + i * 0.425
    set bmargin at screen 0.15
    set tmargin at screen 0.915
    set label 1 panel_title(search eq 'neat' ? 'A' : 'B', name_of(search)) at graph 0,1.06 left textcolor rgb ink
    set label 2 lacks('endpoint_paths', setting) at graph 0.5,0.5 center textcolor rgb 0x777777
    set ylabel (search eq 'neat' ? 'x at the end (cell diameters)' : '') offset 0.8,0 textcolor rgb ink
    if (i == 0) { unset colorbox; set format y '%g' } else {
        set format y ''
        set colorbox user origin 0.915,0.2 size 0.014,0.66 noborder
        set cblabel 'individuals per generation and cell diameter' offset 0.5,0 font ',7' textcolor rgb ink
    }
    of_run(value) = stringcolumn('role') eq 'best' ? of(setting, value) : NaN
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
