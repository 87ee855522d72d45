# SPDX-License-Identifier: MIT
# The archive of a search at the end of its best run, by the generation that added an individual. Given: shown, settings of
# series.gp, and of each its kind: plane, places where individuals ended; line, their x against the generation; numbers,
# the first two numbers of a descriptor of another kind.
load 'paper/figures/series.gp'
rows = (words(shown) + 1) / 2
height = 7.3 * rows - 0.1
load 'paper/figures/style.gp'
if (!exists("GPFUN_title_of")) title_of(k) = label(k)
if (!exists("GPFUN_axis_of")) axis_of(k, number) = number == 1 ? 'first number of the descriptor' : 'second number of the descriptor'

last = last_of('generations')
set cbrange [0:last]
set cbtics 0, generation_tics(last)
side = 0.35 # of the width, the square of a plane
set multiplot
unset key
do for [n = 1:words(shown)] {
    k = int(word(shown, n))
    kind = word(kinds, n)
    undefine END_*
    set offsets 0, 0, 0, 0
    set xrange [*:*]
    set yrange [*:*]
    stats table('archives') using (of(setting[k], kind eq 'line' ? abs(column('x')) : max(abs(column('x')), abs(column('y'))))) name 'END' nooutput
    dots = found(0) < 4000 ? 0.35 : 0.2
    reach = 1.05 * largest(1)
    at = (n - 1) % 2
    left = 0.075 + at * 0.555
    set lmargin at screen left
    set rmargin at screen left + (kind eq 'line' && at == 1 ? 0.355 : side)
    set tmargin at screen 1 - (0.52 + 7.3 * ((n - 1) / 2)) / height
    set bmargin at screen 1 - (0.52 + side * width + 7.3 * ((n - 1) / 2)) / height
    set label 1 panel_title(words(shown) > 1 ? letter(n) : '', title_of(k)) at graph 0,1.06 left textcolor rgb ink
    set label 2 lacks('archives', setting[k]) at graph 0.5,0.5 center textcolor rgb 0x777777
    if (kind eq 'line') {
        unset colorbox
        set size noratio
        set grid noxtics ytics
        set xrange [0:last]
        set yrange [-reach:reach]
        set xtics 0, generation_tics(last)
        set xlabel 'generation of entry' offset 0,0.9 textcolor rgb ink
        set ylabel 'x (cell diameters)' offset 1.2,0 textcolor rgb ink
        plot @unseen, table('archives') using (of(setting[k], column('generation'))):(column('x')):(column('generation')) \
                 with points pointtype 7 pointsize dots linecolor palette
    } else {
        if (at == 1) { unset colorbox } else { set colorbox user origin left + side + 0.015,1 - (0.52 + 0.9 * side * width + 7.3 * ((n - 1) / 2)) / height size 0.014,0.8 * side * width / height noborder }
        set cblabel 'generation' offset 0.5,0 textcolor rgb ink
        set xtics autofreq
        set grid xtics ytics linewidth 0.5 linecolor rgb pale dashtype 1
        if (kind eq 'plane') {
            set size ratio -1
            set xrange [-reach:reach]
            set yrange [-reach:reach]
            set xlabel 'x (cell diameters)' offset 0,0.9 textcolor rgb ink
            set ylabel 'y (cell diameters)' offset 1.2,0 textcolor rgb ink
        } else {
            set size noratio
            set xrange [*:*] noextend
            set yrange [*:*] noextend
            set offsets graph 0.04, graph 0.04, graph 0.04, graph 0.04
            set xlabel axis_of(k, 1) offset 0,0.9 textcolor rgb ink
            set ylabel axis_of(k, 2) offset 1.2,0 textcolor rgb ink
        }
        plot table('archives') using (of(setting[k], column('x'))):(column('y')):(column('generation')) \
                 with points pointtype 7 pointsize dots linecolor palette
    }
}
unset multiplot
