# SPDX-License-Identifier: MIT
# The map of elites at the end of a setting's best run: the fitness of the elite in every niche of the first two numbers of
# the descriptor; of niches that differ in further numbers the best. Given: shown, settings of series.gp; extra, the folder
# of elites.csv (setting, x_low, x_high, y_low, y_high, fitness); first and second, arrays with the names of the numbers.
load 'paper/figures/series.gp'
rows = (words(shown) + 1) / 2
height = 0.6 + 6.6 * rows
load 'paper/figures/style.gp'
if (!exists("GPFUN_title_of")) title_of(k) = label(k)

side = 0.35 # of the width
unset key
unset grid
set multiplot
do for [n = 1:words(shown)] {
    k = int(word(shown, n))
    left = 0.075 + ((n - 1) % 2) * 0.5
    set lmargin at screen left
    set rmargin at screen left + side
    set tmargin at screen 1 - (0.52 + 6.6 * ((n - 1) / 2)) / height
    set bmargin at screen 1 - (0.52 + 5.1 + 6.6 * ((n - 1) / 2)) / height
    set label 1 panel_title(words(shown) > 1 ? letter(n) : '', title_of(k)) at graph 0,1.06 left textcolor rgb ink
    set xlabel first[n] offset 0,0.9 textcolor rgb ink
    set ylabel second[n] offset 1.2,0 textcolor rgb ink
    set cbrange [0:*]
    set colorbox user origin left + side + 0.01,1 - (0.52 + 4.6 + 6.6 * ((n - 1) / 2)) / height size 0.012,4.1 / height noborder
    set cblabel fitness_label offset 0.3,0 font ',8' textcolor rgb ink
    set xrange [*:*] noextend
    set yrange [*:*] noextend
    plot extra.'/elites.csv' using (of(setting[k], (column('x_low') + column('x_high')) / 2)):((column('y_low') + column('y_high')) / 2) \
             :(column('x_low')):(column('x_high')):(column('y_low')):(column('y_high')):(column('fitness')) with boxxyerror fillcolor palette
}
unset multiplot
