# SPDX-License-Identifier: MIT
# Reads, in this order, the names of all files (part=files), the sources (part=code) and the pages (part=pages). See
# documents.sh.

function report(message) {
    printf "%s:%d: %s\n", FILENAME, FNR, message
    errors++
}

# ---- What exists -----------------------------------------------------------------------------------------------------
part == "files" {
    file[$0] = 1
    folder = $0
    name = $0
    sub(/^.*\//, "", name)
    named[name] = 1
    while (sub(/\/[^\/]*$/, "", folder)) file[folder] = file[folder "/"] = 1
    for (ends = $0; sub(/^[^\/]*\//, "", ends);) ending[ends] = 1
    # The executable of a test file (tests/CMakeLists.txt).
    if (sub(/_test\.cpp$/, "", name)) {
        name = $0
        gsub(/^tests\/((core|scripting)\/)?|_test\.cpp$/, "", name)
        gsub(/\//, "_", name)
        word["test_" name] = 1
    }
    if (match($0, /^paper\/decisions\/[0-9]+/)) decision[substr($0, RSTART + 16, RLENGTH - 16)] = 1
    sub(/\/.*/, "")
    top[$0] = 1
    next
}

# The comment that a line of a source ends in; its code is left in `code`.
function comment_of(line,   mark, at) {
    mark = FILENAME ~ /\.(h|cpp|inl|in)$/ ? "//" : FILENAME ~ /\.lua$/ ? "--" : FILENAME ~ /\.tex$/ ? "%" : FILENAME ~ /\.json$/ ? "\001" : "#"
    at = index(line, mark)
    # "://" is part of an address, and "#" or "--" within a word no comment.
    if (at > 1 && substr(line, at - 1, 1) !~ /[ \t;]/) at = 0
    code = at ? substr(line, 1, at - 1) : line
    return at ? substr(line, at + length(mark)) : ""
}

function keep_words(line,   list, n, i, joined) {
    joined = line
    gsub(/[^A-Za-z0-9_-]+/, " ", joined)
    n = split(joined, list, " ")
    for (i = 1; i <= n; i++) word[list[i]] = 1
    gsub(/-+/, " ", joined)
    n = split(joined, list, " ")
    for (i = 1; i <= n; i++) word[list[i]] = 1
    # File names in strings.
    n = split(line, list, /[^A-Za-z0-9_.-]+/)
    for (i = 1; i <= n; i++) if (list[i] ~ /[a-z]\.[a-z]/) named[list[i]] = 1
}

# What the program calls its commands and options is in string literals, with dashes or without.
function keep_literals(line,   literal) {
    while (match(line, /"[a-z0-9, -]+"/)) {
        literal = substr(line, RSTART + 1, RLENGTH - 2)
        line = substr(line, RSTART + RLENGTH)
        sub(/^.*--/, "", literal)
        said[literal] = 1
    }
}

part == "code" {
    check_comment(comment_of($0))
    keep_words(code)
    if (FILENAME ~ /^scripting\//) keep_literals(code)
    if (FILENAME == "Makefile") {
        if (match($0, /^[a-z -]+:/)) {
            n = split(substr($0, 1, RLENGTH - 1), list, " ")
            for (i = 1; i <= n; i++) target[list[i]] = 1
        }
        if (match($0, /\$\(?[A-Z_]+/) || match($0, /^[A-Z_]+/)) {
            n = split($0, list, /[^A-Z_]+/)
            for (i = 1; i <= n; i++) variable[list[i]] = 1
        }
    }
    next
}

# ---- Checks ----------------------------------------------------------------------------------------------------------
# Whether a file exists by this path, in which * stands for anything and <name> or NN for one name or number.
function has_file(path,   pattern, each) {
    if (path in file) return 1
    if (path !~ /[*<]|NN/) return 0
    pattern = path
    gsub(/\./, "\\.", pattern)
    gsub(/\*/, ".*", pattern)
    gsub(/<[a-z_]+>/, "[^/]+", pattern)
    gsub(/N+/, "[^/]+", pattern)
    for (each in file) if (each ~ "^" pattern "$") return 1
    return 0
}

function check_decisions(text,   number) {
    while (match(text, /(^|[^A-Za-z0-9.,_-])00[0-9][0-9]([^0-9A-Za-z.]|\.?$)/)) {
        number = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        gsub(/[^0-9]/, "", number)
        if (!(number in decision)) report("decision " number " does not exist")
    }
}

# A comment names a file by its path or the end of it.
function check_comment(text,   rest, path) {
    check_decisions(text)
    rest = text
    while (match(rest, /[A-Za-z_.\/$<][A-Za-z0-9_.*<>\/-]*\.(h|cpp|inl|lua|sh|awk|md|tex)([^A-Za-z0-9_\/*.-]|\.?$|\.[^A-Za-z0-9])/)) {
        path = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        sub(/[^A-Za-z0-9_*>-]+$/, "", path)
        # Neither what is made, nor placeholders.
        if (path ~ /^[.\/$<]|^build\/|^script\/|^(file|script)\.|^[A-Z]+\./) continue
        if (!(path in ending) && !(path in named) && !has_file(path) && !has_file("*/" path)) report("the comment names " path ", which does not exist")
    }
}

function check_path(path) {
    sub(/#.*/, "", path)
    if (!has_file(path)) report(path " does not exist")
}

function check_make(list, n,   i) {
    for (i = 2; i <= n; i++) {
        if (list[i] ~ /^[A-Z_]+=/) {
            sub(/=.*/, "", list[i])
            if (!(list[i] in variable)) report("the Makefile reads no variable " list[i])
        } else if (list[i] ~ /^[a-z-]+$/) {
            if (!(list[i] in target)) report("there is no target `make " list[i] "`")
        } else return
    }
}

function check_option(option) {
    sub(/^--/, "", option)
    sub(/[^a-z0-9-].*$/, "", option)
    if (!(option in said) && option !~ /^(help|version)$/) report("planula has no option --" option)
}

function check_planula(list, n,   i) {
    if (list[2] ~ /^[a-z]+$/ && !(list[2] in said)) report("planula has no command " list[2])
    for (i = 2; i <= n; i++) if (list[i] ~ /^--[a-z]/) check_option(list[i])
}

# One word of a code span or of a command: a path, or the name of a file.
function check_name(name,   first) {
    gsub(/^[('"]+|[)'",;:]+$/, "", name)
    first = name
    sub(/\/.*/, "", first)
    if (name ~ /\// && first in top && name !~ /[=$|]/) check_path(name)
    else if (name ~ /^[a-z0-9_-]+\.(csv|lua|h|cpp|inl|sh|awk|md|tex|gp|svg)(\.gz)?$/ && !(name in named)) report(name " does not exist")
}

# The words of a code span that is one identifier, or several joined by '.', ':' or '()'.
function check_identifier(span,   list, n, i) {
    sub(/\(\)$/, "", span)
    if (span in file || span !~ /^[A-Za-z_][A-Za-z0-9_.:-]*$/ || span ~ /^-|\.[a-z]+$/) return
    n = split(span, list, /[.:]+/)
    for (i = 1; i <= n; i++) if (list[i] != "" && !(list[i] in word) && !(list[i] in target)) report("nothing is called " list[i])
}

function check_span(span,   list, n, i) {
    n = split(span, list, " ")
    if (n == 1) {
        if (span ~ /^--[a-z]/) check_option(span)
        else check_identifier(span)
    }
    if (list[1] == "cp") file[list[3]] = 1
    for (i = 1; i <= n; i++) check_name(list[i])
    if (list[1] == "make") check_make(list, n)
    if (list[1] ~ /^(build\/)?planula$/) check_planula(list, n)
}

# ---- The pages -------------------------------------------------------------------------------------------------------
FNR == 1 { fence = ""; text = ""; sections = 0 }
/^## / { sections++ }
FILENAME == "CHANGELOG.md" && (sections > 1 || /(is|are) gone|\((was )?`|, which was /) { next }
/^ *```/ {
    fence = fence == "" ? substr($0, index($0, "```") + 3) : ""
    if (fence == "" ) next
    if (fence !~ /^[a-z]/) fence = "text"
    next
}
fence == "sh" {
    sub(/(^| )#.*/, "")
    check_span($0)
    next
}
fence != "" { next }
# What the reader of a page is to make: <!-- new: NAME … -->.
/^<!-- new: / {
    for (i = 3; i < NF; i++) file[$i] = word[$i] = said[$i] = named[$i] = 1
    next
}
{
    check_decisions($0)
    line = $0
    while (match(line, /\]\([^)]*\)/)) {
        path = substr(line, RSTART + 2, RLENGTH - 3)
        line = substr(line, RSTART + RLENGTH)
        own = FILENAME
        if (!sub(/\/[^\/]*$/, "/", own)) own = ""
        while (sub(/^\.\.\//, "", path)) sub(/[^\/]*\/$/, "", own)
        if (path !~ /^(https?:|#|mailto:)/) check_path(own path)
    }
    # A code span may go on to the next line.
    text = text == "" ? $0 : text " " $0
    while (match(text, /`[^`]+`/)) {
        span = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, RSTART + RLENGTH)
        check_span(span)
    }
    if (text !~ /`/) text = ""
}

END {
    if (errors) { printf "documents: %d names of what does not exist\n", errors; exit 1 }
    print "documents: all that pages and comments name exists"
}
