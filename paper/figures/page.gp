# SPDX-License-Identifier: MIT
# Draws what page.lua has laid out in cm. Given: layout (its folder) and out; with words = 0 a PNG without text.
height = 1 # until the layout sets it
load 'paper/figures/style.gp'
load layout.'/page.gp'
set datafile separator tab
set datafile commentschars "\001" # a title may have any other
part(name) = layout.'/'.name.'.tsv'
if (!exists('words')) words = 1
if (!exists('density')) density = 80 # pixels per cm without text
if (words) { eval terminal(width, height) } else { eval sprintf('set terminal pngcairo size %d,%d fontscale 1 linewidth %g pointscale 1', density * width, density * height, density / 40.0) }
set termoption noenhanced # texts of the page are plain
set output out

unset border
unset tics
unset key
unset grid
unset colorbox
set margins screen 0, screen 1, screen 0, screen 1
set xrange [0:width]
set yrange [-height:0]
# The styles of lines, numbered as in page.lua.
set style arrow 1 nohead linewidth 0.3 linecolor rgb 0x60555555
set style arrow 2 nohead linewidth 0.8 linecolor rgb 0x222222
set style arrow 3 nohead linewidth 1.2 linecolor rgb 0x8C7B6B
set style arrow 4 nohead linewidth 1.2 linecolor rgb 0xD55E00
set style arrow 5 nohead linewidth 1.6 linecolor rgb ink
set style arrow 6 head filled size 0.16,20 linewidth 0.8 linecolor rgb ink
set style arrow 7 nohead linewidth 0.6 linecolor rgb 0xBBBBBB
set style arrow 8 nohead linewidth 0.5 linecolor rgb ink
set style arrow 9 nohead linewidth 0.8 linecolor rgb neat
set style arrow 10 nohead linewidth 0.8 linecolor rgb ns
set style arrow 11 nohead linewidth 0.3 linecolor rgb 0x90777777
set style arrow 12 nohead linewidth 1.0 linecolor rgb 0x999999
set style arrow 13 nohead linewidth 1.3 linecolor rgb 0x762A83
set style arrow 14 nohead linewidth 1.3 linecolor rgb 0xA57BB5
set style arrow 15 nohead linewidth 1.3 linecolor rgb 0xC9C9C9
set style arrow 16 nohead linewidth 1.3 linecolor rgb 0x6DB873
set style arrow 17 nohead linewidth 1.3 linecolor rgb 0x1B7837
# A point of type 7 and size 1 is a disc of this radius in cm, 3 units of the terminal: far less to draw than gnuplot's
# circles, which are polygons.
disc = !words ? 3.0 / density : ending eq 'png' ? 3 * 2.8 / 80 : ending eq 'svg' ? 3 / 37.8 : 3 * 2.54 / 72
size_of(radius) = radius / disc
on(n) = column('layer') == n ? column('x') : NaN
styled(style) = words && stringcolumn('style') eq style ? stringcolumn('text') : ''
pictures = ''
do for [n = 1:layers] {
    pictures = pictures.sprintf("part('cells') using (on(%d)):'y':(size_of(column('radius'))):'colour' with points pointtype 7 pointsize variable linecolor rgb variable, ", n) \
                       .sprintf("part('lines') using (on(%d)):'y':'dx':'dy':'style' with vectors arrowstyle variable, ", n)
}
eval 'plot '.pictures."part('labels') using 'x':'y':(styled('letter')) with labels left font 'Latin Modern Roman:Bold,9' textcolor rgb ink" \
     .", part('labels') using 'x':'y':(styled('title')) with labels left textcolor rgb ink" \
     .", part('labels') using 'x':'y':(styled('left')) with labels left font ',7' textcolor rgb ink" \
     .", part('labels') using 'x':'y':(styled('right')) with labels right font ',7' textcolor rgb ink" \
     .", part('labels') using 'x':'y':(styled('quiet')) with labels left font ',7' textcolor rgb 0x666666" \
     .", part('labels') using 'x':'y':(styled('note')) with labels center font ',7' textcolor rgb 0x666666" \
     .", part('labels') using 'x':'y':(styled('missing')) with labels left font ',8' textcolor rgb 0x666666"
