# SPDX-License-Identifier: MIT
# Best fitness in each generation: of each series the mean of the runs (solid) and the bootstrap interval of the mean
# (dashed, shaded). The generations that claims name are marked; of those beyond the runs a note tells. Given: panels,
# those of series.gp that are drawn, in rows of two.
columns = words(panels) > 1 ? 2 : 1
rows = (words(panels) + 1) / 2
if (!exists('key_room')) key_room = columns > 1 ? 3 : 9
load 'paper/figures/series.gp'
height = 6.9 * rows + key_height
load 'paper/figures/style.gp'

last = last_of('generations')
# The claims about a generation's best in settings of a panel: id and generation, one after the other.
marks = ''
mark(id, generation) = (marks = marks.id.' '.(generation eq '0' ? manifest('generations_planned') : generation).' ', 0)
find_marks = "marks = ''; stats table('claims') using (stringcolumn('test') eq 'best_at_generation' && strstrt(names, ' '.stringcolumn('setting_a').' ') > 0 " \
             ."? mark(stringcolumn('id'), stringcolumn('generation')) : NaN) nooutput"

set multiplot layout rows,columns margins 0.08,0.985,1.104 / height,1 - (0.8625 + key_height) / height spacing 0.08,1.95 / height
set xrange [0:last]
set xtics 0, generation_tics(last)
set yrange [0:*]
set offsets 0, 0, graph 0.05, 0
set xlabel 'generation' offset 0,0.9 textcolor rgb ink
unset key
load 'paper/figures/key.gp'
do for [n = 1:words(panels)] {
    p = int(word(panels, n))
    names = ' '
    missing = ''
    do for [i = 1:words(members[p])] {
        names = names.setting[member(p, i)].' '
        missing = missing.lacks('curves', setting[member(p, i)])
    }
    eval find_marks
    beyond = ''
    do for [i = 1:words(marks) / 2] {
        id = word(marks, 2 * i - 1)
        at = int(word(marks, 2 * i))
        if (at - 1 <= last) {
            set arrow from at - 1, graph 0 to at - 1, graph 1 nohead linewidth 0.8 dashtype 3 linecolor rgb 0x777777 back
            set label id at at - 1, graph 0.045 right offset -0.4,0 font ',7' textcolor rgb 0x666666
        } else { beyond = beyond.(beyond eq '' ? '' : ', ').sprintf('%s (generation %d)', id, at) }
    }
    set label (beyond eq '' ? '' : "beyond these runs:\n".beyond) at graph 0.99,0.13 right font ',7' textcolor rgb 0x666666
    set label missing at graph 0.5,0.5 center textcolor rgb 0x777777
    set label panel_title(words(panels) > 1 ? letter(n) : '', panel_name(p)) at graph 0,1.1 left textcolor rgb ink
    set ylabel (n % columns == 1 || columns == 1 ? fitness_label : '') offset 0.8,0 textcolor rgb ink
    plot @unseen, for [i = 1:words(members[p])] k = member(p, i) table('curves') \
             using (of(setting[k], column('generation'))):(column('low')):(column('high')) \
             with filledcurves fillcolor rgb tint(k) fillstyle transparent solid 0.13 noborder, \
         for [i = 1:words(members[p])] for [bound in 'low high'] k = member(p, i) table('curves') \
             using (of(setting[k], column('generation'))):(column(bound)) \
             with lines linewidth 0.8 dashtype 2 linecolor rgb tint(k), \
         for [i = 1:words(members[p])] k = member(p, i) table('curves') \
             using (of(setting[k], column('generation'))):(column('mean')) \
             with linespoints linewidth 1.8 pointtype symbol(series_of[k]) pointsize 0.45 pointinterval generation_tics(last) linecolor rgb tint(k)
    unset arrow
    unset label
}
unset multiplot
