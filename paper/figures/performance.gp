# SPDX-License-Identifier: MIT
# Best fitness in each generation, NEAT against novelty search: mean of the runs (solid) and bootstrap interval of the
# mean (dashed, shaded). The generations that claims of the original name are marked; of those beyond the runs a note
# tells. Panel A in water, B on land. Given: actuation (osc or grn).
height = 6.9
load 'paper/figures/style.gp'

last = last_of('generations')
# The claims about a generation's best in settings of a group: id and generation, one after the other.
marks = ''
mark(id, generation) = (marks = marks.id.' '.(generation eq '0' ? manifest('generations_planned') : generation).' ', 0)
find_marks = "marks = ''; stats table('claims') using (stringcolumn('test') eq 'best_at_generation' && strstrt(stringcolumn('setting_a'), group) == 1 " \
             ."? mark(stringcolumn('id'), stringcolumn('generation')) : NaN) nooutput"

set multiplot layout 1,2 margins 0.07,0.985,0.16,0.875 spacing 0.08,0
set xrange [0:last]
set xtics 0, generation_tics(last)
set yrange [0:*]
set offsets 0, 0, graph 0.05, 0
set xlabel 'generation' offset 0,0.9 textcolor rgb ink
do for [world in 'aq te'] {
    group = actuation.'-'.world
    eval find_marks
    beyond = ''
    do for [i = 1:words(marks) / 2] {
        id = word(marks, 2 * i - 1)
        at = int(word(marks, 2 * i))
        if (at - 1 <= last) {
            set arrow 10 + i from at - 1, graph 0 to at - 1, graph 1 nohead linewidth 0.8 dashtype 3 linecolor rgb 0x777777 back
            set label 10 + i id at at - 1, graph 0.045 right offset -0.4,0 font ',6.5' textcolor rgb 0x777777
        } else { beyond = beyond.(beyond eq '' ? '' : ', ').sprintf('%s (generation %d)', id, at) }
    }
    set label 2 (beyond eq '' ? '' : 'beyond these runs: '.beyond) at graph 1,1.03 right font ',6.5' textcolor rgb 0x777777
    set label 3 lacks('curves', group.'-neat').lacks('curves', group.'-ns') at graph 0.5,0.5 center textcolor rgb 0x777777
    set label 1 panel_title(world eq 'aq' ? 'A' : 'B', world eq 'aq' ? 'water' : 'land') at graph 0,1.1 left textcolor rgb ink
    set ylabel (world eq 'aq' ? 'best fitness (cell diameters)' : '') offset 0.8,0 textcolor rgb ink
    if (world eq 'aq') { set key at graph 1,1.16 right top horizontal Left reverse samplen 1.2 width -4 } else { unset key }
    plot @unseen, for [search in 'neat ns'] setting = group.'-'.search table('curves') \
             using (of(setting, column('generation'))):(column('low')):(column('high')) \
             with filledcurves fillcolor rgb colour(search) fillstyle transparent solid 0.13 noborder notitle, \
         for [search in 'neat ns'] for [bound in 'low high'] setting = group.'-'.search table('curves') \
             using (of(setting, column('generation'))):(column(bound)) \
             with lines linewidth 0.8 dashtype 2 linecolor rgb colour(search) notitle, \
         for [search in 'neat ns'] setting = group.'-'.search table('curves') \
             using (of(setting, column('generation'))):(column('mean')) \
             with lines linewidth 1.8 linecolor rgb colour(search) title name_of(search)
    unset arrow
    unset label
}
unset multiplot
