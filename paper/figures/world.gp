# SPDX-License-Identifier: MIT
# Where the individuals of a setting's best run came to rest over their world, by generation, with its ground, ceiling and
# obstacles; a strip for each setting, in the places of the world. Given: shown, settings of series.gp; extra, the folder of
# world_points.csv (setting, generation, x, y) and world_lines.csv (setting, x, y, in blocks); left, right, low and high,
# arrays with the ends of each strip.
load 'paper/figures/series.gp'
count = words(shown)
room = 13.2 # of a strip, cm
strip(n) = max(1.3, min(7, room * (high[n] - low[n]) / (right[n] - left[n])))
max(a, b) = a > b ? a : b
min(a, b) = a < b ? a : b
height = 0.4 + sum [n = 1:count] (strip(n) + 1.75)
load 'paper/figures/style.gp'
if (!exists("GPFUN_title_of")) title_of(k) = label(k)

last = last_of('generations')
set cbrange [0:last]
set cbtics 0, generation_tics(last)
set cblabel 'generation' offset 0.5,0 textcolor rgb ink
set xlabel 'x (cell diameters)' offset 0,0.9 textcolor rgb ink
set ylabel 'y' offset 1.2,0 textcolor rgb ink
unset key
unset grid
set multiplot
top = 0.5
do for [n = 1:count] {
    k = int(word(shown, n))
    set lmargin at screen 1.2 / width
    set rmargin at screen (1.2 + room) / width
    set tmargin at screen 1 - top / height
    set bmargin at screen 1 - (top + strip(n)) / height
    set xrange [left[n]:right[n]]
    set yrange [low[n]:high[n]]
    set ytics max(1, ceil((high[n] - low[n]) / (strip(n) / 0.45)))
    if (strip(n) < 2) { set ytics 10 * ceil((high[n] - low[n]) / 30.0) }
    set label 1 panel_title(count > 1 ? letter(n) : '', title_of(k)) at graph 0,screen 1 - (top - 0.22) / height left textcolor rgb ink
    if (n == 1) { set colorbox user origin (1.2 + room + 0.3) / width,1 - (top + max(1.3, min(4, strip(1)))) / height size 0.014,max(1.3, min(4, strip(1))) / height noborder } else { unset colorbox }
    plot @unseen, extra.'/world_points.csv' using (of(setting[k], column('x'))):(column('y')):(column('generation')) \
             with points pointtype 7 pointsize 0.3 linecolor palette, \
         extra.'/world_lines.csv' using (of(setting[k], column('x'))):(column('y')) with lines linewidth 1.4 linecolor rgb 0x8C7B6B
    top = top + strip(n) + 1.75
}
unset multiplot
