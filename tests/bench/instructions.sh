#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Counts the instructions of fixed pieces of work with valgrind's callgrind and compares them with those kept in
# instructions.csv; counts, unlike times, are not noisy. A piece that needs more than TOLERANCE percent more than before
# fails; one that needs that much less is reported, so that the new count can be kept.
#
#   instructions.sh PROGRAM [PIECE…]   compares all pieces, or these; PROGRAM is the built `work`
#   instructions.sh PROGRAM --keep     keeps the counts of this compiler
set -euo pipefail
export LC_ALL=C
program=$1
kept=$(dirname "$0")/instructions.csv
tolerance=${TOLERANCE:-3}
compiler=$("$program" --compiler)
counts=$(mktemp)
log=$(mktemp)
trap 'rm -f "$counts" "$log"' EXIT

keep=
pieces=("${@:2}")
if [[ ${pieces[*]} == --keep ]]; then keep=yes pieces=(); fi
((${#pieces[@]})) || mapfile -t pieces < <("$program")
for piece in "${pieces[@]}"; do
    failed=
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$piece" > "$log" 2>&1 || failed=yes
    count=$(sed -n 's/^==.*Collected : \([0-9]*\)$/\1/p' "$log")
    if [[ -n $failed || -z $count ]]; then
        cat "$log"
        echo "instructions: $piece was not counted"
        exit 1
    fi
    echo "$compiler,$piece,$count" >> "$counts"
done

if [[ -n $keep ]]; then
    others=$(awk -F, -v compiler="$compiler" 'NR > 1 && $1 != compiler' "$kept" 2> /dev/null || true)
    { echo 'compiler,piece,instructions'; echo "$others"; cat "$counts"; } | sed '/^$/d' > "$kept.new"
    mv "$kept.new" "$kept"
    echo "instructions: $(wc -l < "$counts") counts of $compiler kept"
    exit 0
fi

awk -F, -v compiler="$compiler" -v tolerance="$tolerance" '
    FNR == NR { if ($1 == compiler) before[$2] = $3; next }
    !($2 in before) { next }
    {
        change = 100 * ($3 / before[$2] - 1)
        compared++
        printf "%-28s %12d %+7.2f %%\n", $2, $3, change
        if (change > tolerance) { failed++; print "instructions: " $2 " needs more than was kept" }
        if (change < -tolerance) print "instructions: " $2 " needs less; keep that with KEEP=1"
    }
    END {
        if (!compared) print "instructions: no counts of " compiler " are kept; KEEP=1 keeps some"
        printf "instructions: %d passed, %d failed\n", compared - failed, failed + !compared
        exit failed > 0 || !compared
    }' "$kept" "$counts"
