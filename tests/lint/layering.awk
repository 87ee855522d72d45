# SPDX-License-Identifier: MIT
# Checks C++ sources against the room lines of the CMakeLists.txt that are read first. See layering.sh.

function report(message) {
    printf "%s:%d: %s\n", FILENAME, FNR, message
    errors++
}

# Whether the current file lies in one of the rooms of a list.
function within(list) { return index(" " list " ", " " room " ") > 0 }

# Whether the current file is one of a list of files without their endings.
function is_file(list,   stem) {
    stem = FILENAME
    sub(/\.[a-z]+$/, "", stem)
    return index(" " list " ", " " stem " ") > 0
}

# The line without comments and without the text of string literals; a block comment may go on to the next line.
function code_of(line,   code, c, two, i, quote) {
    code = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        two = substr(line, i, 2)
        if (in_comment) {
            if (two == "*/") { in_comment = 0; i++ }
        } else if (quote != "") {
            if (c == "\\") i++
            else if (c == quote) { quote = ""; code = code c }
        } else if (two == "//") {
            break
        } else if (two == "/*") {
            in_comment = 1
            i++
        } else {
            # An apostrophe between digits separates them.
            if (c == "\"" || (c == "'" && code !~ /[0-9a-fA-F]$/)) quote = c
            code = code c
        }
    }
    return code
}

# An include of the project's own, "room/file.h": it must exist, and the room that includes it must list its room.
function check_own(path,   target) {
    target = path
    sub(/\/.*/, "", target)
    if (!(target in depends)) { report("includes \"" path "\", which names no room"); return }
    if (index(" " depends[room] " ", " " target " ")) used[room, target] = 1
    else if (room != target) report("room " room " includes \"" path "\", but " home[room] "/CMakeLists.txt does not list " target " in its DEPENDS")
    if (!((home[target] "/" path) in exists)) report("includes \"" path "\", which does not exist")
    if (path == "base/random.h" && !within("base genome evolution statistics experiment analysis"))
        report("room " room " draws random numbers; only base genome evolution statistics experiment analysis may")
}

# Of every room line: the rooms it names stand above it, and the room includes something of each.
function check_rooms(   i, j, name, names, count) {
    for (i = 1; i <= rooms; i++) {
        name = room_at[i]
        count = split(depends[name], names, " ")
        for (j = 1; j <= count; j++)
            if (!(names[j] in place) || place[names[j]] >= i) report_room(name, "no room " names[j] " stands above it")
            else if (!((name, names[j]) in used)) report_room(name, "lists " names[j] ", but includes nothing of it")
    }
}

function report_room(name, message) {
    printf "%s/CMakeLists.txt:%d: room %s: %s\n", home[name], line_of[name], name, message
    errors++
}

# Notes the unordered containers of a file and of its header, which loops go over a variable, and whose begin() is taken.
function look_for_walks(   stem, name) {
    stem = FILENAME
    sub(/\.[a-z]+$/, "", stem)
    if (match(code, /unordered_(multi)?(map|set) ?<.*> +[A-Za-z_0-9]+ *[;={(]/)) {
        name = substr(code, RSTART, RLENGTH)
        sub(/ *[;={(]$/, "", name)
        sub(/.*[ >]/, "", name)
        unordered[stem, name] = 1
    }
    name = ""
    if (match(code, /for ?\(.* : [A-Za-z_0-9]+\)/)) {
        name = substr(code, RSTART, RLENGTH - 1)
        sub(/.* : /, "", name)
    } else if (match(code, /[A-Za-z_0-9]+\.c?begin\(\)/)) {
        name = substr(code, RSTART, RLENGTH)
        sub(/\..*/, "", name)
    }
    if (name != "") walks[stem, name, FILENAME, FNR] = FILENAME ":" FNR
}

# An include of a system header.
function check_system(header) {
    if (header ~ /^(fstream|iostream|cstdio|stdio\.h)$/ && !within("storage record language program"))
        report("<" header "> outside storage, record, language and program: files are touched at the edge only")
    if (header ~ /^(thread|future|pthread\.h|omp\.h|execution)$/ && !is_file("core/base/parallel"))
        report("<" header "> outside base/parallel: the only threads are there")
    if (header ~ /^(random)$/) report("<random>: chance comes from the streams of base/random.h")
    if (header ~ /^([a-z]*intrin\.h|arm_neon\.h|arm_sve\.h|x86gprintrin\.h|experimental\/simd)$/ && !is_file("core/base/lanes"))
        report("<" header "> outside base/lanes: the only intrinsics are there")
    if (header ~ /^(chrono|ctime|time\.h|sys\/time\.h)$/ && !within("language program"))
        report("<" header "> outside language and program: nothing else knows a clock")
}

BEGIN {
    functions = "a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erfc?|[tl]gamma|fma"
    qualified = "(std ?::|(^|[^A-Za-z0-9_>:]) ?::) ?(" functions ")[fl]? ?\\("
    bare = "(^|[^A-Za-z0-9_:.>])(" functions ")[fl]? ?\\("
}

# ---- The rooms ----
FILENAME ~ /CMakeLists\.txt$/ {
    if (match($0, /^room\([a-z_]+/)) {
        name = substr($0, 6, RLENGTH - 5)
        home[name] = FILENAME
        sub(/\/.*/, "", home[name])
        line_of[name] = FNR
        room_at[++rooms] = name
        place[name] = rooms
        depends[name] = ""
        in_room = 1
        sub(/^room\([a-z_]+/, "")
    }
    if (in_room) {
        in_room = !/\)/
        sub(/\).*/, "")
        sub(/DEPENDS/, "")
        depends[name] = depends[name] " " $0
        gsub(/ +/, " ", depends[name])
    }
    next
}

# ---- The sources ----
FNR == 1 {
    if (!prepared) {
        prepared = 1
        for (i = 1; i < ARGC; i++) exists[ARGV[i]] = 1
    }
    split(FILENAME, parts, "/")
    room = parts[2]
    in_comment = 0
    files++
    if (home[room] != parts[1]) report("lies in a folder without a room line in " parts[1] "/CMakeLists.txt")
}

{ code = code_of($0) }

code ~ /^ *# *include/ {
    if (match($0, /"[^"]+"/)) check_own(substr($0, RSTART + 1, RLENGTH - 2))
    else if (match($0, /<[^>]+>/)) check_system(substr($0, RSTART + 1, RLENGTH - 2))
    next
}

# base/math defines functions of these names; everywhere else they must be called as math::name.
code ~ qualified || (code ~ bare && !is_file("core/base/math")) {
    report("a transcendental of libm: its bits differ between processors; use planula::math of base/math.h")
}
code ~ /std ?:: ?[a-z_]+_distribution|std ?:: ?(random_device|mt19937|minstd_rand|default_random_engine|shuffle|random_shuffle|sample)[^A-Za-z0-9_]|(^|[^A-Za-z0-9_:.>])s?rand(om)? ?\(/ {
    report("chance that differs between libraries: use a Stream of base/random.h")
}
code ~ /std ?:: ?(transform_)?reduce[^A-Za-z0-9_]|std ?:: ?hash[^A-Za-z0-9_]/ {
    report("an order or a hash that differs between libraries: sum in a loop; sort by innovation, id, slot or index")
}
code ~ /std ?:: ?(time|clock) ?\(|(^|[^A-Za-z0-9_])(clock_gettime|gettimeofday) ?\(/ && !within("language program") {
    report("a clock outside language and program: results may not depend on it")
}
# Unordered containers may be looked into, but not walked through: their order differs between libraries.
{ look_for_walks() }
code ~ /(^|[^A-Za-z0-9_])(getenv|secure_getenv|setlocale)|std ?:: ?locale/ && !within("program") {
    report("environment or locale outside program: results may depend on neither")
}
code ~ /(^|[^A-Za-z0-9_])(strto(d|f|ld|l|ul|ll|ull)|ato(f|i|l|ll)|sto(d|f|ld|i|l|ll|ul|ull)) ?\(/ && !is_file("core/base/text") {
    report("text to number by a function that follows the locale: use base/text.h")
}
# Errors cross between C++ and Lua in one place (language/gate.h).
code ~ /(^|[^A-Za-z0-9_])catch *\(/ && room == "language" && !is_file("scripting/language/gate") {
    report("an exception is caught outside language/gate.h: throw, and let the gate make a Lua error of it")
}
code ~ /lua_c?pcall *\(/ && parts[1] == "scripting" && !is_file("scripting/language/lua_state scripting/language/wrap_base") {
    report("a protected call outside LuaState: use call() or inspect()")
}

END {
    for (walk in walks) {
        split(walk, of, SUBSEP)
        if ((of[1], of[2]) in unordered) {
            print walks[walk] ": walks through " of[2] ", an unordered container, whose order differs between libraries"
            errors++
        }
    }
    if (!rooms) { print "layering: no room line found"; errors++ }
    check_rooms()
    if (errors) { printf "layering: %d violations\n", errors; exit 1 }
    printf "layering: %d files in %d rooms include what their lines list, and all of it\n", files, rooms
}
