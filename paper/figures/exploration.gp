# SPDX-License-Identifier: MIT
# Where the individuals of a run ended, in an open world. A random share of all of them (points, by generation) and the best
# of each generation (line; dots where it is the best so far). Given: shown, settings of series.gp, and roles, of each the
# run that is drawn, best or median.
load 'paper/figures/series.gp'
rows = (words(shown) + 1) / 2
height = 0.92 + 6.99 * rows
load 'paper/figures/style.gp'
if (!exists("GPFUN_title_of")) title_of(k, role) = label(k).', '.role.' run'

names = ' '
do for [n = 1:words(shown)] { names = names.setting[int(word(shown, n))].' ' }
# One square range around the origin for all panels.
reach = 1
drawn(value) = strstrt(names, ' '.stringcolumn('setting').' ') > 0 ? value : NaN
do for [name in 'endpoint_paths endpoints'] {
    stats table(name) using (drawn(max(abs(column('x')), abs(column('y'))))) name 'END' nooutput
    reach = max(reach, largest(reach))
}
reach = 1.05 * reach

# Few points are drawn larger.
dot = found(0) < 6000 ? 0.36 : 0.2

last = last_of('generations')
set cbrange [0:last]
set cbtics 0, generation_tics(last)
set size ratio -1
set grid xtics ytics linewidth 0.5 linecolor rgb pale dashtype 1
set xrange [-reach:reach]
set yrange [-reach:reach]
unset key

set multiplot
square = 0.395 # of the width
top_edge = 1 - 0.417 / height
pitch = (square * width + 0.67) / height
do for [n = 1:words(shown)] {
    k = int(word(shown, n))
    role = word(roles, n)
    at = (n - 1) % 2
    row = (n - 1) / 2
    left = 0.075 + at * (square + 0.03)
    top = top_edge - row * pitch
    set lmargin at screen left
    set rmargin at screen left + square
    set tmargin at screen top
    set bmargin at screen top - square * width / height
    set label 1 panel_title(words(shown) > 1 ? letter(n) : '', title_of(k, role)) at graph 0,1.035 left textcolor rgb ink
    set label 2 lacks('endpoint_paths', setting[k]) at graph 0.5,0.5 center textcolor rgb 0x777777
    is_lowest = n + 2 > words(shown)
    set xlabel (is_lowest ? 'x (cell diameters)' : '') offset 0,0.9 textcolor rgb ink
    set ylabel (at == 0 ? 'y (cell diameters)' : '') offset 1.2,0 textcolor rgb ink
    if (is_lowest) { set format x '%g' } else { set format x '' }
    if (at == 0) { set format y '%g' } else { set format y '' }
    if (n == words(shown)) {
        set colorbox user origin 0.915,0.22 size 0.016,(words(shown) > 2 ? 0.56 : 0.5) noborder
        set cblabel 'generation' offset 0.5,0 textcolor rgb ink
    } else { unset colorbox }
    of_run(value) = stringcolumn('role') eq role ? of(setting[k], value) : NaN
    # 1 in the rows of a best so far.
    highest = -1
    is_record(fitness) = fitness > highest ? (highest = fitness, 1) : 0
    record(value) = of_run(1) == 1 && is_record(column('fitness')) ? value : NaN
    plot @unseen, table('endpoints') using (of_run(column('x'))):(column('y')):(column('generation')) \
             with points pointtype 7 pointsize dot linecolor palette, \
         table('endpoint_paths') using (of_run(column('x'))):(column('y')) with lines linewidth 1.8 linecolor rgb 0x30FFFFFF, \
         table('endpoint_paths') using (of_run(column('x'))):(column('y')) with lines linewidth 0.7 linecolor rgb 0x111111, \
         table('endpoint_paths') using (record(column('x'))):(column('y')) \
             with points pointtype 7 pointsize 0.62 linecolor rgb 0xFFFFFF, \
         highest = -1 table('endpoint_paths') using (record(column('x'))):(column('y')) \
             with points pointtype 7 pointsize 0.42 linecolor rgb 0xD5200E, \
         '+' using (0):(0) every ::0::0 with points pointtype 1 pointsize 0.8 linewidth 2.4 linecolor rgb 0xFFFFFF, \
         '+' using (0):(0) every ::0::0 with points pointtype 1 pointsize 0.7 linewidth 1.2 linecolor rgb 0x111111
}
unset multiplot
