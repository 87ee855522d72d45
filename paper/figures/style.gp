# SPDX-License-Identifier: MIT
# The style of every figure. Given by the caller: data (folder of tables), out (file to write), height (cm).
# Colours are those of Okabe and Ito, which people with any kind of colour vision can tell apart.
width = 16.0
# The terminal of the file's ending: pdf, svg or png; lengths are cm, and all three show the same.
ending = out[strlen(out) - 2:]
terminal(width, height) = \
    ending eq 'svg' ? sprintf("set terminal svg size %.1f,%.1f dynamic background '#ffffff' font 'Latin Modern Roman,Georgia,serif,9' fontscale 1 linewidth 1.33 dashlength 0.6", 37.8 * width, 37.8 * height) : \
    ending eq 'png' ? sprintf("set terminal pngcairo size %d,%d font 'Latin Modern Roman,9' fontscale 1.65 linewidth 2.2 dashlength 0.6 pointscale 2.8", 80 * width, 80 * height) : \
    sprintf("set terminal pdfcairo size %gcm,%gcm font 'Latin Modern Roman,9' fontscale 0.75 linewidth 1 dashlength 0.6", width, height)
eval terminal(width, height)
set encoding utf8
set output out

neat = 0x0072B2
ns = 0xD55E00
ink = 0x333333
pale = 0xDDDDDD
colour(search) = search eq 'neat' ? neat : ns
name_of(search) = search eq 'neat' ? 'NEAT' : 'novelty search'

# Tables are comma separated with one header line; columns are addressed by name.
set datafile separator comma
set datafile columnheaders
set datafile missing NaN
table(name) = data.'/'.name.'.csv'

# The value if the row belongs to the setting, else nothing.
of(setting, value) = stringcolumn('setting') eq setting ? value : NaN
# The text of a row of manifest.csv.
manifest(key) = system("awk -F, -v key=".key." '$1 == key { print $2 }' '".data."/manifest.csv'")

set border 3 linewidth 0.6 linecolor rgb ink
set tics nomirror out scale 0.4 textcolor rgb ink
set xtics offset 0,0.45
set ytics offset 0.4,0
set grid ytics linewidth 0.5 linecolor rgb pale dashtype 1
set style fill solid noborder
set key textcolor rgb ink spacing 1.2
panel_title(letter, text) = letter eq '' ? text : '{/:Bold '.letter.'}   '.text
letter(n) = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'[n:n]
if (!exists("GPFUN_panel_name")) panel_name(p) = panel[p]

# Colours of generations, light for the first to dark for the last.
set palette defined (0 '#fde725', 0.25 '#5ec962', 0.5 '#21918c', 0.75 '#3b528b', 1 '#440154')

# Distance of tics: 1, 2 or 5 times a power of ten, so that about five of them stand below an axis of this length; along
# generations it is whole.
decade(length) = 10.0 ** floor(log10(length))
step_of(length) = decade(length) * (length < 1.5 * decade(length) ? 1 : length < 3.5 * decade(length) ? 2 : \
                                    length < 7.5 * decade(length) ? 5 : 10)
generation_tics(last) = max(1, step_of(last / 5.0))

max(a, b) = a > b ? a : b
min(a, b) = a < b ? a : b

# The results of `stats … name 'END'`; if a table has no fitting row, its variables stay undefined.
found(otherwise) = exists('END_records') ? END_records : otherwise
largest(otherwise) = exists('END_max') ? END_max : otherwise
lowest(otherwise) = exists('END_min') ? END_min : otherwise
# An invisible point, for panels whose tables may have no fitting row: gnuplot draws no axes for an empty plot.
unseen = "'+' using (0):(0) every ::0::0 with points pointsize 0 notitle"

# The rows of a table that belong to a setting, its first column; OSC AQ NS for osc-aq-ns.
rows_of(name, setting) = int(system("grep -c '^".setting.",' '".table(name)."' || true"))
short(setting) = system("echo ".setting." | tr 'a-z-' 'A-Z '")
# What a panel says where its settings have no data; nothing if all have some.
lacks(name, setting) = rows_of(name, setting) > 0 ? '' : "no data of ".short(setting)."\n"
# The last of so many generations, the end of an axis that begins at 0 and is never empty.
last_of(key) = manifest(key) > 1 ? manifest(key) - 1 : 1
