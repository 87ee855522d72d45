# SPDX-License-Identifier: MIT
# What a figure compares. Given by the caller: design, a file that sets the arrays
#   setting    the settings by name; all else calls them by their number
#   series_of  of each setting the number of its series
#   series     the names of the series, as the key shows them; hue, their colours
#   panel      the titles of the panels; members, of each panel its settings
# and fitness_label, the label of an axis of fitness. Texts are written for gnuplot's enhanced mode. The article's design
# is article.gp; that of any experiment is made by plan.lua.
if (!exists('design')) design = 'paper/figures/article.gp'
load design
member(p, i) = int(word(members[p], i))
label(k) = series[series_of[k]]
tint(k) = hue[series_of[k]]
# The symbol on the curves of a series, by which they differ in grey print, too; none on the first.
symbols = '0 6 4 8 10 12 7 5 9 11'
symbol(s) = int(word(symbols, (s - 1) % 10 + 1))

# The key: one line of all series at the right of the titles, if there is room for it, else lines of its own above the
# panels. Lengths are cm.
if (!exists('key_room')) key_room = 4.6
key_entry(s) = 1.2 + 0.118 * strlen(series[s])
key_all = |series| > 1 ? (sum [s = 1:|series|] key_entry(s)) : 0
key_widest = 0
do for [s = 1:|series|] { key_widest = key_entry(s) > key_widest ? key_entry(s) : key_widest }
key_columns = key_widest > 14 ? 1 : int(15 / key_widest)
key_height = key_all > key_room ? 0.15 + 0.4 * ceil(|series| / (1.0 * key_columns)) : 0
