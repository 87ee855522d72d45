# SPDX-License-Identifier: MIT
# Best fitness in each generation, NEAT against novelty search: mean of the runs (solid) and bootstrap interval of the
# mean (dashed, shaded). Panel A in water, B on land. Given: actuation (osc or grn).
height = 6.6
load 'paper/figures/style.gp'

set multiplot layout 1,2 margins 0.07,0.985,0.165,0.915 spacing 0.08,0
last = manifest('generations') > 1 ? manifest('generations') - 1 : 1
set xrange [0:last]
set xtics 0, generation_tics(last)
set yrange [0:*]
set xlabel 'generation' offset 0,0.9 textcolor rgb ink
do for [world in 'aq te'] {
    set label 1 panel_title(world eq 'aq' ? 'A' : 'B', world eq 'aq' ? 'water' : 'land') at graph 0,1.06 left textcolor rgb ink
    set ylabel (world eq 'aq' ? 'best fitness (cell diameters)' : '') offset 0.8,0 textcolor rgb ink
    if (world eq 'aq') { set key at graph 1,1.12 right top horizontal Left reverse samplen 1.2 width -4 } else { unset key }
    plot @unseen, for [search in 'neat ns'] setting = actuation.'-'.world.'-'.search table('curves') \
             using (of(setting, column('generation'))):(column('low')):(column('high')) \
             with filledcurves fillcolor rgb colour(search) fillstyle transparent solid 0.13 noborder notitle, \
         for [search in 'neat ns'] for [bound in 'low high'] setting = actuation.'-'.world.'-'.search table('curves') \
             using (of(setting, column('generation'))):(column(bound)) \
             with lines linewidth 0.8 dashtype 2 linecolor rgb colour(search) notitle, \
         for [search in 'neat ns'] setting = actuation.'-'.world.'-'.search table('curves') \
             using (of(setting, column('generation'))):(column('mean')) \
             with lines linewidth 1.8 linecolor rgb colour(search) title name_of(search)
}
unset multiplot
