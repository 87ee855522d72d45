# SPDX-License-Identifier: MIT
# Portraits of animats, laid out in cm by morphologies.lua. Given: layout (its folder) and out; a name that
# ends in .png gives a picture without text. Cells are discs coloured by their actuation signal, from contraction (red)
# to expansion (blue), and grey while they grow; springs are thin lines, the outline is darker, the ground a line.
height = 1 # until page.gp sets it
load 'paper/figures/style.gp'
load layout.'/page.gp'
data = layout
words = out[strlen(out) - 3:] ne '.png'
if (words) { eval terminal(width, height) } else { eval sprintf('set terminal pngcairo size %d,%d fontscale 1 linewidth 2', 80 * width, 80 * height) }
set output out

unset border
unset tics
unset key
unset grid
unset colorbox
set margins screen 0, screen 1, screen 0, screen 1
set xrange [0:width]
set yrange [-height:0]
set cbrange [-1:1]
set palette defined (-1 '#b2182b', -0.5 '#ef8a62', 0 '#f4f1ea', 0.5 '#67a9cf', 1 '#2166ac')
# A point of type 7 and size 1 is a disc of radius 3 units of the terminal, pt in PDF and pixels in PNG: far less to draw
# than gnuplot's circles, which are polygons.
size_of(radius) = radius / (words ? 3 * 2.54 / 72 : 3 / 80.0)
styled(style) = words && stringcolumn('style') eq style ? stringcolumn('text') : ''
plot table('grounds') using 'x':'y':'dx':(0) with vectors nohead linewidth 1.2 linecolor rgb 0x8C7B6B, \
     table('cells') using (stringcolumn('stage') eq 'growth' ? column('x') : NaN):'y':(size_of(column('radius'))) \
         with points pointtype 7 pointsize variable linecolor rgb 0xCFD8DC, \
     table('cells') using (stringcolumn('stage') eq 'gait' ? column('x') : NaN):'y':(size_of(column('radius'))):'signal' \
         with points pointtype 7 pointsize variable linecolor palette, \
     table('links') using (column('outline') == 0 ? column('x') : NaN):'y':'dx':'dy' \
         with vectors nohead linewidth 0.3 linecolor rgb 0x60555555, \
     table('links') using (column('outline') == 1 ? column('x') : NaN):'y':'dx':'dy' \
         with vectors nohead linewidth 0.9 linecolor rgb 0x222222, \
     table('labels') using 'x':'y':(styled('letter')) with labels left font 'Latin Modern Roman:Bold,9' textcolor rgb ink, \
     table('labels') using 'x':'y':(styled('title')) with labels left textcolor rgb ink, \
     table('labels') using 'x':'y':(styled('step')) with labels center font ',6.5' textcolor rgb 0x888888
