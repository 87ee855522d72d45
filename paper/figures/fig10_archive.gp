# SPDX-License-Identifier: MIT
# Figure 10 of the original: the archive of novelty search at the end of its best run with oscillators. A: in water, where the
# archived individuals ended, by the generation that added them; B: on land, x against that generation.
height = 7.2
load 'paper/figures/style.gp'

last = last_of('generations')
set cbrange [0:last]
set cbtics 0, generation_tics(last)
stats table('archives') using (of('osc-aq-ns', max(abs(column('x')), abs(column('y'))))) name 'END' nooutput
water_dots = found(0)
water_reach = 1.05 * largest(1)
stats table('archives') using (of('osc-te-ns', abs(column('x')))) name 'END' nooutput
land_dots = found(0)
land_reach = 1.05 * largest(1)
set multiplot
unset key
side = 0.35 # of the width, the square of panel A
set lmargin at screen 0.075
set rmargin at screen 0.075 + side
set bmargin at screen 0.15
set tmargin at screen 0.15 + side * width / height
set size ratio -1
set grid xtics ytics linewidth 0.5 linecolor rgb pale dashtype 1
set xrange [-water_reach:water_reach]
set yrange [-water_reach:water_reach]
set xlabel 'x (cell diameters)' offset 0,0.9 textcolor rgb ink
set ylabel 'y (cell diameters)' offset 1.2,0 textcolor rgb ink
set label 1 panel_title('A', 'water') at graph 0,1.06 left textcolor rgb ink
set colorbox user origin 0.075 + side + 0.015,0.2 size 0.014,0.6 noborder
set cblabel 'generation' offset 0.5,0 textcolor rgb ink
set label 2 lacks('archives', 'osc-aq-ns') at graph 0.5,0.5 center textcolor rgb 0x777777
plot @unseen, table('archives') using (of('osc-aq-ns', column('x'))):(column('y')):(column('generation')) \
         with points pointtype 7 pointsize (water_dots < 4000 ? 0.35 : 0.2) linecolor palette

unset colorbox
set size noratio
set lmargin at screen 0.63
set rmargin at screen 0.985
set grid noxtics ytics
set xrange [0:last]
set yrange [-land_reach:land_reach]
set xtics 0, generation_tics(last)
set xlabel 'generation of entry' offset 0,0.9 textcolor rgb ink
set ylabel 'x (cell diameters)' offset 1.2,0 textcolor rgb ink
set label 1 panel_title('B', 'land')
set label 2 lacks('archives', 'osc-te-ns')
plot @unseen, table('archives') using (of('osc-te-ns', column('generation'))):(column('x')):(column('generation')) \
         with points pointtype 7 pointsize (land_dots < 4000 ? 0.35 : 0.2) linecolor palette
unset multiplot
