# SPDX-License-Identifier: MIT
# Sets the key of series.gp, to be drawn with the next plot: for each series a line and its name.
if (key_all > 0) {
    at_x = key_height > 0 ? 0.9 : width - 0.1 - key_all
    do for [s = 1:|series|] {
        row = key_height > 0 ? (s - 1) / key_columns : 0
        if (key_height > 0 && (s - 1) % key_columns == 0) { at_x = 0.9 }
        y = 1 - ((key_height > 0 ? 0.3 : 0.37) + 0.4 * row) / height
        set arrow from screen at_x / width,y to screen (at_x + 0.45) / width,y nohead linewidth 1.8 linecolor rgb hue[s]
        if (symbol(s) > 0) { set label '' at screen (at_x + 0.225) / width,y point pointtype symbol(s) pointsize 0.45 linewidth 1 linecolor rgb hue[s] }
        set label series[s] at screen (at_x + 0.55) / width,y left textcolor rgb ink
        at_x = at_x + (key_height > 0 ? 15.0 / key_columns : key_entry(s))
    }
}
