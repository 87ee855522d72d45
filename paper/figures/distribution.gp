# SPDX-License-Identifier: MIT
# Distribution of fitness in the last generation, each run relative to the highest fitness of that generation, mean of runs
# (upper row). The same in every generation (lower rows). A column for each panel of series.gp.
key_room = 0
load 'paper/figures/series.gp'
rows = 0
do for [p = 1:|panel|] { rows = words(members[p]) > rows ? words(members[p]) : rows }
if (|series| <= 2) key_height = 0
step = rows > 2 ? 2.2 : 2.9 # from one of the lower rows to the next
height = 5.4 + key_height + step * rows
load 'paper/figures/style.gp'

at_height(cm) = 1 - (cm + key_height) / height
last = last_of('generations')
stats table('fitness_shares') using (100 * column('share')) name 'END' nooutput
top = 1.05 * largest(100)
most = 25 # per cent; larger shares have the last colour
set palette defined (0 '#f7f7f4', 0.15 '#d9e5b0', 0.4 '#7fc28a', 0.7 '#2b7f93', 1 '#1b2f6b')
set cbrange [0:most]
unset colorbox
set multiplot
wide = 0.82 / |panel| - 0.012 # of the width
if (key_height > 0) { load 'paper/figures/key.gp' }
do for [p = 1:|panel|] {
    set lmargin at screen 0.075 + (p - 1) * (wide + 0.012)
    set rmargin at screen 0.075 + (p - 1) * (wide + 0.012) + wide
    set tmargin at screen at_height(0.504)
    set bmargin at screen at_height(3.36)
    set xrange [0:1]
    set yrange [0:top]
    set grid ytics
    if (p < |panel|) { set xtics ('0' 0, '0.5' 0.5) } else { set xtics ('0' 0, '0.5' 0.5, '1' 1) }
    missing = ''
    do for [i = 1:words(members[p])] { missing = missing.lacks('fitness_shares', setting[member(p, i)]) }
    set label panel_title(|panel| > 1 ? letter(p) : '', panel_name(p)) at graph 0,1.08 left textcolor rgb ink
    set label (p == 1 ? 'fitness relative to the highest of the generation' : '') at screen 0.075 + 0.82 / 2,at_height(4.09) center textcolor rgb ink
    set label missing at graph 0.5,0.5 center font ',7' textcolor rgb 0x777777
    set ylabel (p == 1 ? 'individuals (%)' : '') offset 0.2,0 textcolor rgb ink
    set xlabel ''
    if (p == 1) { set format y '%g' } else { set format y '' }
    if (p == 1 && key_height == 0 && |series| > 1) { set key top left Left reverse samplen 0.8 } else { unset key }
    plot @unseen, for [i = 1:words(members[p])] k = member(p, i) table('fitness_shares') \
             using (of(setting[k], (column('low') + column('high')) / 2)):(100 * column('share')):(column('high') - column('low')) \
             with boxes fillstyle transparent solid 0.35 noborder linecolor rgb tint(k) title label(k)
    unset label
    unset arrow
    unset key
    unset grid
    set xrange [-0.5:last + 0.5]
    set yrange [0:1]
    set xtics 0, (|panel| > 4 ? 2 : 1) * generation_tics(last)
    do for [i = 1:words(members[p])] {
        k = member(p, i)
        is_lowest = i == words(members[p])
        set tmargin at screen at_height(4.70 + (i - 1) * step)
        set bmargin at screen at_height(4.70 + i * step - 0.33)
        set label label(k) at graph 0.03,0.9 left font ',7' textcolor rgb ink front
        set label lacks('fitness_history', setting[k]) at graph 0.5,0.5 center font ',7' textcolor rgb 0x777777
        set ylabel (p == 1 ? 'relative fitness' : '') offset 0.2,0 textcolor rgb ink
        if (p == 1) { set format y '%g' } else { set format y '' }
        set xlabel (is_lowest ? 'generation' : '') offset 0,0.9 textcolor rgb ink
        if (is_lowest) { set format x '%g' } else { set format x '' }
        if (p == |panel| && is_lowest) {
            set colorbox user origin 0.91,at_height(4.70 + rows * step - 0.5) size 0.012,(rows * step - 0.5) / height noborder
            set cbtics ('0' 0, '5' 5, '10' 10, '15' 15, '20' 20, '≥ 25' 25)
            set cblabel 'individuals (%)' offset 0.3,0 textcolor rgb ink
        }
        plot @unseen, table('fitness_history') using (of(setting[k], (column('generation_low') + column('generation_high')) / 2)) \
                 :((column('low') + column('high')) / 2):(column('generation_low') - 0.5):(column('generation_high') + 0.5) \
                 :(column('low')):(column('high')):(100 * column('share')) with boxxyerror fillcolor palette
        unset label
    }
    set format x '%g'
}
unset multiplot
