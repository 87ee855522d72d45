#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What must hold for every tracked file: sources name their licence in the first lines; no text holds a path of some
# machine, a line ending of another system, a blank at a line's end, or a mark of unfinished work.
# Prints FILE:LINE: what is wrong; fails if anything is.
#
#   sources.sh [ROOT]       ROOT is the checkout; by default the one this script lies in
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$here/../..}"
export LC_ALL=C

source "$here/files.sh"
mapfile -t files < <(files)
sources=() texts=()
for file in "${files[@]}"; do
    case $file in
        *.h | *.cpp | *.cu | *.cuh | *.inl | *.in | *.lua | *.js | *.mjs | *.css | *.html | *.gp | *.tex | *.bib | *.sh | *.awk | *.cmake | *CMakeLists.txt | Makefile | .ci/run) sources+=("$file") ;;
    esac
    case $file in
        *.png | *.pdf | *.gz | LICENSE) ;;
        data/*.csv | tests/golden/*) ;;
        *) texts+=("$file") ;;
    esac
done
# A checkout without a source would pass everything.
((${#sources[@]})) || { echo "sources: no source file found in $PWD" >&2; exit 2; }

errors=0
found() { # found MESSAGE: every line FILE:LINE:… of standard input is an error
    while IFS=: read -r file line _; do
        echo "$file:$line: $1"
        errors=$((errors + 1))
    done
}
found 'no SPDX-License-Identifier in the first five lines' < <(
    for file in "${sources[@]}"; do head -n 5 "$file" | grep -q 'SPDX-License-Identifier: ' || echo "$file:1:"; done
)
search() { grep -nE "$1" /dev/null "${texts[@]}" || true; } # search PATTERN
machine='(^|[^A-Za-z0-9_.}-])/(home|root|Users|work|workspace|mnt|media|srv|tmp|var/tmp)/[A-Za-z0-9_.]'
found 'a path of some machine' < <(search "$machine")
found 'a carriage return' < <(search $'\r')
found 'a blank at the end of the line' < <(search '[ 	]+$')
found 'a mark of unfinished work' < <(search '(^|[^A-Za-z])(TO''DO|FIX''ME|XX''X|HA''CK)([^A-Za-z]|$)')

# A parameter that nothing public gives has a page that says why.
ours=$(sed -nE 's/^(PARAMETER|CHOICE)\([A-Za-z]+, ([a-z0-9_]+),.*, "ours", .*/\2/p' core/parameters/parameters.inl 2> /dev/null || true)
found 'a parameter of ours that no page of paper/decisions names' < <(
    for name in $ours; do
        grep -qF "\`$name\`" paper/decisions/*.md || grep -nE "^(PARAMETER|CHOICE)\([A-Za-z]+, $name," /dev/null core/parameters/parameters.inl
    done
)

# The article's rules are the whole model: every parameter but those of statistics, and every alternative of a choice.
rules=paper/sections/rules.tex
table=core/parameters/parameters.inl
model=$(sed '/^SECTION(StatisticsParameters,/,/^SECTION_END/d' "$table" 2> /dev/null | sed -nE 's/^(PARAMETER|CHOICE)\([A-Za-z]+, ([a-z0-9_]+),.*/\2/p' || true)
found 'a parameter of the model that no rule of the article uses' < <(
    for name in $model; do
        grep -qE "[\\](parameter|percent|choice)\{$name\}" "$rules" || grep -nE "^(PARAMETER|CHOICE)\([A-Za-z]+, $name," /dev/null "$table"
    done
)
found 'an alternative of a choice that no rule of the article describes' < <(
    { grep -n '^CHOICE' "$table" 2> /dev/null || true; } | while IFS= read -r choice; do
        for name in $(sed -E 's/.*", ([a-z0-9_, ]+)\)$/\1/; s/,//g' <<< "$choice"); do
            grep -qE "[\\]alternative\{$name\}" "$rules" || echo "$table:${choice%%:*}:"
        done
    done
)
# A rule that is cited by its number must be in the article.
found 'a rule that the article does not have' < <(
    cited='(^|[^A-Za-z])rules? [A-Z]{1,2}[0-9]+((,| and| to) [A-Z]{1,2}[0-9]+)*|[\\]rul\{[A-Z]{1,2}[0-9]+'
    { grep -noE "$cited" /dev/null "${texts[@]}" || true; } | while IFS=: read -r file line words; do
        for rule in $(grep -oE '[A-Z]{1,2}[0-9]+' <<< "$words"); do
            grep -qE "[\\]law\{$rule\}" "$rules" || echo "$file:$line:"
        done
    done
)

if ((errors)); then
    echo "sources: $errors violations"
    exit 1
fi
echo "sources: ${#sources[@]} sources name their licence; ${#texts[@]} texts are clean"
