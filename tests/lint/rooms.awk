# SPDX-License-Identifier: MIT
# Draws the rooms of the CMakeLists.txt that it reads as an SVG: a box for each room line, with the comment above the
# line, and a line down to each room that it includes and does not reach through another. Rooms that three of five
# include are the ground, without lines. Boxes lie in layers, each as high as the rooms above it allow (Sugiyama et al.
# 1981).

function max(a, b) { return a > b ? a : b }
function min(a, b) { return a < b ? a : b }
function escaped(text) { gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text); return text }

/^#/ { note = substr($0, 3); next }
match($0, /^room\([a-z_]+/) {
    name = substr($0, 6, RLENGTH - 5)
    rooms[++count] = name
    about[name] = note
    home[name] = FILENAME
    sub(/\/[^\/]*$/, "", home[name])
    sub(/^.*\//, "", home[name])
    in_room = 1
    sub(/^room\([a-z_]+/, "")
}
in_room {
    in_room = !/\)/
    sub(/\).*/, "")
    gsub(/DEPENDS|PUBLIC|PRIVATE/, " ")
    parts = split($0, list, " ")
    for (i = 1; i <= parts; i++) includes[name, list[i]] = 1
}
!in_room { note = "" }

# Whether a room reaches another: rooms stand below what they include.
function find_reach(   i, j, k) {
    for (i = 1; i <= count; i++)
        for (j = 1; j < i; j++) {
            if ((rooms[i], rooms[j]) in includes) reaches[rooms[i], rooms[j]] = 1
            for (k = j + 1; k < i; k++)
                if ((rooms[i], rooms[k]) in includes && (rooms[k], rooms[j]) in reaches) reaches[rooms[i], rooms[j]] = 1
        }
}

# Of each room its layer, 1 the highest: one below the lowest that includes it.
function find_layers(   i, j, any) {
    for (i = count; i >= 1; i--) {
        layer[rooms[i]] = 1
        any = 0
        for (j = i + 1; j <= count; j++)
            if ((rooms[j], rooms[i]) in includes) {
                layer[rooms[i]] = max(layer[rooms[i]], layer[rooms[j]] + 1)
                any++
            }
        ground[rooms[i]] = 5 * any >= 3 * (count - 1)
        if (!ground[rooms[i]]) layers = max(layers, layer[rooms[i]])
    }
}

function add_node(node, at) { row[at, ++size[at]] = node; x[node] = size[at] * 100 }
function add_edge(upper, lower) { below[upper] = below[upper] " " lower; above[lower] = above[lower] " " upper }

# Boxes, and on the way of each line that crosses a layer a point there.
function find_nodes(   i, j, k, through, from, to, last, at) {
    for (i = count; i >= 1; i--) if (!ground[rooms[i]]) add_node(rooms[i], layer[rooms[i]])
    for (i = count; i >= 1; i--)
        for (j = 1; j < i; j++) {
            from = rooms[i]
            to = rooms[j]
            if (!((from, to) in includes) || ground[to]) continue
            through = 0
            for (k = j + 1; k < i; k++) if ((from, rooms[k]) in reaches && (rooms[k], to) in reaches) through = 1
            if (through) continue
            last = from
            way[++ways] = from
            for (at = layer[from] + 1; at < layer[to]; at++) {
                add_node("." from "." to "." at, at)
                add_edge(last, "." from "." to "." at)
                last = "." from "." to "." at
                way[ways] = way[ways] " " last
            }
            add_edge(last, to)
            way[ways] = way[ways] " " to
        }
}

function mean_of(list, otherwise,   nodes, n, i, sum) {
    n = split(list, nodes, " ")
    for (i = 1; i <= n; i++) sum += x[nodes[i]]
    return n ? sum / n : otherwise
}

# What a node wants in the end: the middle of its neighbours, of which points on the same line count ten times.
function straight(node,   nodes, n, i, weight, sum, weights) {
    n = split(above[node] below[node], nodes, " ")
    for (i = 1; i <= n; i++) {
        weight = node ~ /^\./ && nodes[i] ~ /^\./ ? 10 : 1
        sum += weight * x[nodes[i]]
        weights += weight
    }
    return n ? sum / weights : x[node]
}

# Sorts the nodes of a layer by `want`, equals as they stand.
function sort_layer(at,   i, j, node) {
    for (i = 2; i <= size[at]; i++) {
        node = row[at, i]
        for (j = i; j > 1 && want[row[at, j - 1]] > want[node]; j--) row[at, j] = row[at, j - 1]
        row[at, j] = node
    }
}

function half(node) { return node ~ /^\./ ? 14 : BOX / 2 + 14 }

# Places the nodes of a layer as near as can be to what they want, in their order and apart: runs of nodes that touch
# move together, to the mean of what their members want.
function place_layer(at,   i, node, offset, runs, sum, members, first, last) {
    offset = 0
    for (i = 1; i <= size[at]; i++) {
        node = row[at, i]
        if (i > 1) offset += half(row[at, i - 1]) + half(node)
        off[i] = offset
        sum[++runs] = want[node] - offset
        members[runs] = 1
        while (runs > 1 && sum[runs - 1] / members[runs - 1] > sum[runs] / members[runs]) {
            sum[runs - 1] += sum[runs]
            members[runs - 1] += members[runs]
            runs--
        }
    }
    for (first = i = 1; i <= runs; i++)
        for (last = first + members[i]; first < last; first++) x[row[at, first]] = sum[i] / members[i] + off[first]
}

function crossings(   at, i, j, a, b, n, m, u, v, sum) {
    for (at = 1; at < layers; at++)
        for (i = 1; i <= size[at]; i++)
            for (j = i + 1; j <= size[at]; j++) {
                n = split(below[row[at, i]], a, " ")
                m = split(below[row[at, j]], b, " ")
                for (u = 1; u <= n; u++) for (v = 1; v <= m; v++) sum += x[a[u]] > x[b[v]]
            }
    return sum + 0
}

# Orders the layers by the means of their neighbours, down and up in turn, and keeps the best order seen.
function order_layers(   sweep, step, at, i, best, now, key) {
    best = 1e9
    for (sweep = 0; sweep < 24; sweep++) {
        for (step = 1; step <= layers; step++) {
            at = sweep % 2 ? layers + 1 - step : step
            for (i = 1; i <= size[at]; i++) want[row[at, i]] = mean_of(sweep % 2 ? below[row[at, i]] : above[row[at, i]], x[row[at, i]])
            sort_layer(at)
            place_layer(at)
        }
        now = crossings()
        if (now < best) {
            best = now
            for (key in row) kept[key] = row[key]
        }
    }
    for (key in kept) row[key] = kept[key]
    for (at = 1; at <= layers; at++) for (i = 1; i <= size[at]; i++) x[row[at, i]] = i * BOX
    for (sweep = 0; sweep < 400; sweep++)
        for (step = 1; step <= layers; step++) {
            at = sweep % 2 ? layers + 1 - step : step
            for (i = 1; i <= size[at]; i++) want[row[at, i]] = straight(row[at, i])
            place_layer(at)
        }
}

function y_of(at) { return 24 + (at - 1) * (HIGH + GAP) }

function draw_text(class, middle, base, text) { printf "<text class=\"%s\" x=\"%.0f\" y=\"%.0f\">%s</text>\n", class, middle, base, escaped(text) }

# A box with the room's name and, in lines of at most `most` characters, its comment.
function draw_box(name, left, top, wide, most,   middle, words, n, i, line, lines) {
    middle = left + wide / 2
    sub(/\.$/, "", about[name])
    n = split(about[name], words, " ")
    for (i = 1; i <= n; i++)
        if (lines && length(line[lines] " " words[i]) <= most) line[lines] = line[lines] " " words[i]
        else line[++lines] = words[i]
    printf "<rect class=\"%s\" x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" height=\"%.0f\" rx=\"8\"/>\n", ground[name] ? "ground" : home[name], left, top, wide, HIGH
    draw_text("name", middle, top + 30 - 7 * lines + 5, name)
    for (i = 1; i <= lines; i++) draw_text("about", middle, top + 30 - 7 * lines + 8 + 15 * i, line[i])
}

# Where a line meets a box: the lines of one side are spread over it, in the order of what they lead to.
function port(node, list, other,   n, nodes, i, place) {
    if (node ~ /^\./) return x[node]
    n = split(list, nodes, " ")
    for (i = 1; i <= n; i++) place += x[nodes[i]] < x[other]
    return x[node] + (place - (n - 1) / 2) * min(40, (BOX - 60) / max(1, n - 1))
}

function draw_way(nodes,   list, n, i, path, top, from, to) {
    n = split(nodes, list, " ")
    for (i = 1; i < n; i++) {
        top = y_of(layer[list[1]] + i - 1) + HIGH
        from = port(list[i], below[list[i]], list[i + 1])
        to = port(list[i + 1], above[list[i + 1]], list[i])
        path = path sprintf("%s%.0f %.0f C%.0f %.0f %.0f %.0f %.0f %.0f", i == 1 ? "M" : " L", from, top, from, top + GAP * 0.6, to, top + GAP * 0.4, to, top + GAP)
    }
    printf "<path d=\"%s\"/>\n", path
}

END {
    BOX = 214
    HIGH = 62
    GAP = 44
    find_reach()
    find_layers()
    find_nodes()
    order_layers()
    low = 1e9
    high = -1e9
    for (i = 1; i <= count; i++) if (!ground[rooms[i]]) {
        low = min(low, x[rooms[i]] - BOX / 2)
        high = max(high, x[rooms[i]] + BOX / 2)
    }
    for (node in x) { low = min(low, x[node] - 10); high = max(high, x[node] + 10) }
    for (node in x) x[node] += 24 - low
    width = high - low + 48
    for (i = 1; i <= count; i++) grounds += ground[rooms[i]]
    height = y_of(layers + 1) + grounds * (HIGH + 10) + 14
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\">\n", width, height, width, height
    print "<title>The rooms of planula: each includes those that a line leads down to</title>"
    print "<style>"
    print "rect { stroke-width: 1.2 } .core { fill: #e8f1fa; stroke: #3b6ea5 } .scripting { fill: #fdf0dd; stroke: #b9772b } .ground { fill: #ececec; stroke: #777 }"
    print "path { fill: none; stroke: #7a8794; stroke-width: 1.6 } text { text-anchor: middle; font-family: Helvetica, Arial, 'DejaVu Sans', sans-serif }"
    print ".name { font-size: 15px; font-weight: bold; fill: #1c2733 } .about { font-size: 11px; fill: #46525e }"
    print "</style>"
    printf "<rect width=\"%.0f\" height=\"%.0f\" fill=\"white\"/>\n", width, height
    for (i = 1; i <= ways; i++) draw_way(way[i])
    for (i = count; i >= 1; i--) if (!ground[rooms[i]]) draw_box(rooms[i], x[rooms[i]] - BOX / 2, y_of(layer[rooms[i]]), BOX, 34)
    for (i = 1; i <= count; i++) if (ground[rooms[i]]) draw_box(rooms[i], 24, y_of(layers + 1) + --grounds * (HIGH + 10), width - 48, 90)
    print "</svg>"
}
