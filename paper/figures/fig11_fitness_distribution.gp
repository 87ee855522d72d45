# SPDX-License-Identifier: MIT
# Figure 11 of the original: distribution of fitness in the last generation, each run relative to the highest fitness of
# that generation, mean of runs (upper row). The same in every generation (lower rows), which the original describes.
height = 11.2
load 'paper/figures/style.gp'

groups = 'osc-aq osc-te grn-aq grn-te'
titles = '"oscillators, water" "oscillators, land" "GRN, water" "GRN, land"'
last = last_of('generations')
stats table('fitness_shares') using (100 * column('share')) name 'END' nooutput
top = 1.05 * largest(100)
most = 25 # per cent; larger shares have the last colour
set palette defined (0 '#f7f7f4', 0.15 '#d9e5b0', 0.4 '#7fc28a', 0.7 '#2b7f93', 1 '#1b2f6b')
set cbrange [0:most]
unset colorbox
set multiplot
panel = 0.193 # of the width
do for [i = 1:4] {
    group = word(groups, i)
    set lmargin at screen 0.075 + (i - 1) * (panel + 0.012)
    set rmargin at screen 0.075 + (i - 1) * (panel + 0.012) + panel
    set tmargin at screen 0.955
    set bmargin at screen 0.70
    set xrange [0:1]
    set yrange [0:top]
    set grid ytics
    if (i < 4) { set xtics ('0' 0, '0.5' 0.5) } else { set xtics ('0' 0, '0.5' 0.5, '1' 1) }
    set label 1 panel_title(word('A B C D', i), word(titles, i)) at graph 0,1.08 left textcolor rgb ink
    set label 2 (i == 1 ? 'fitness relative to the highest of the generation' : '') at screen 0.5,0.635 center textcolor rgb ink
    set label 3 lacks('fitness_shares', group.'-neat').lacks('fitness_shares', group.'-ns') at graph 0.5,0.5 center font ',7' textcolor rgb 0x777777
    set ylabel (i == 1 ? 'individuals (%)' : '') offset 0.2,0 textcolor rgb ink
    set xlabel ''
    if (i == 1) { set format y '%g'; set key top left Left reverse samplen 0.8 } else { set format y ''; unset key }
    plot @unseen, for [search in 'neat ns'] table('fitness_shares') \
             using (of(group.'-'.search, (column('low') + column('high')) / 2)):(100 * column('share')) \
                 :(column('high') - column('low')) \
             with boxes fillstyle transparent solid 0.35 noborder linecolor rgb colour(search) title name_of(search)
    unset label
    unset key
    unset grid
    set xrange [-0.5:last + 0.5]
    set yrange [0:1]
    set xtics 0, max(1, 2 * generation_tics(last))
    do for [row = 1:2] {
        search = word('neat ns', row)
        set tmargin at screen 0.58 - (row - 1) * 0.26
        set bmargin at screen 0.35 - (row - 1) * 0.26
        set label 1 name_of(search) at graph 0.03,0.93 left font ',7' textcolor rgb ink front
        set label 3 lacks('fitness_history', group.'-'.search) at graph 0.5,0.5 center font ',7' textcolor rgb 0x777777
        set ylabel (i == 1 ? 'relative fitness' : '') offset 0.2,0 textcolor rgb ink
        if (i == 1) { set format y '%g' } else { set format y '' }
        set xlabel (row == 2 ? 'generation' : '') offset 0,0.9 textcolor rgb ink
        if (row == 2) { set format x '%g' } else { set format x '' }
        if (i == 4 && row == 2) {
            set colorbox user origin 0.9,0.09 size 0.012,0.49 noborder
            set cbtics ('0' 0, '5' 5, '10' 10, '15' 15, '20' 20, '≥ 25' 25)
            set cblabel 'individuals (%)' offset 0.3,0 textcolor rgb ink
        }
        plot @unseen, table('fitness_history') using (of(group.'-'.search, (column('generation_low') + column('generation_high')) / 2)) \
                 :((column('low') + column('high')) / 2):(column('generation_low') - 0.5):(column('generation_high') + 0.5) \
                 :(column('low')):(column('high')):(100 * column('share')) with boxxyerror fillcolor palette
        unset label
    }
    set format x '%g'
}
unset multiplot
