#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Alters a recorded run at random, again and again: digits, rows and generations of its tables and its chain, saved
# states, files of another seed, the manifest, the identity, the scripts. `planula verify` must find each alteration
# without simulating, and must name the generation if one was altered.
#
#   audit.sh PROGRAM [ALTERATIONS] [SEED]      100 alterations, seed 1
set -euo pipefail
cd "$(dirname "$0")/../.."
program=$(realpath "$1") alterations=${2:-100}
RANDOM=${3:-1}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" run experiments/paper/replication.lua --only osc-aq-ns --seeds 1:2 --population 20 --generations 28 \
    --set development_steps=200 --set locomotion_steps=100 --out "$folder/runs" 2> /dev/null
whole=$folder/runs/osc-aq-ns/seed-001 other=$folder/runs/osc-aq-ns/seed-002 altered=$folder/altered
"$program" verify "$folder/runs" --share 100 > "$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
text_of() { if [[ $1 == *.gz ]]; then gzip -dc "$1"; else cat "$1"; fi; }
# Every table that has rows.
tables=()
for table in generations.csv sizes.csv.gz fitness_classes.csv.gz individuals.csv.gz species.csv.gz champions.csv \
    champion_genomes.csv.gz archive.csv.gz; do
    if (($(text_of "$whole/$table" | wc -l) > 1)); then tables+=("$table"); fi
done
((${#tables[@]} > 5)) || { echo 'audit: the run has too few tables'; exit 1; }

pick() { local -n list=$1; picked=${list[RANDOM % ${#list[@]}]}; }
# edit FILE PROGRAM [NAME=VALUE…]: through awk.
edit() {
    local file=$1 program=$2 options=()
    shift 2
    for word in "$@"; do options+=(-v "$word"); done
    text_of "$file" | awk -F, "${options[@]}" "$program" > "$folder/text"
    if [[ $file == *.gz ]]; then gzip -nc "$folder/text" > "$file"; else cp "$folder/text" "$file"; fi
}
# any_row FILE: sets `row`, a line after the header, and its `generation`.
any_row() {
    local rows
    rows=$(text_of "$1" | wc -l)
    row=$((2 + RANDOM % (rows - 1)))
    generation=$(text_of "$1" | sed -n "${row}p" | cut -d, -f1)
}
# change_digit FILE FIRST: another digit in a row, in its FIRSTth field or later.
change_digit() {
    edit "$1" '
        BEGIN { srand(seed) }
        NR == row {
            start = 1
            for (i = 1; i < first; ++i) start += length($i) + 1
            count = 0
            for (i = start; i <= length($0); ++i) if (substr($0, i, 1) ~ /[0-9]/) place[++count] = i
            if (count) {
                i = place[1 + int(rand() * count)]
                $0 = substr($0, 1, i - 1) (substr($0, i, 1) + 1 + int(rand() * 8)) % 10 substr($0, i + 1)
            }
        }
        { print }' row="$row" first="$2" seed="$RANDOM"
}
change_byte() { # change_byte FILE
    local size place byte
    size=$(stat -c %s "$1")
    place=$(((RANDOM * 32768 + RANDOM) % size))
    byte=$(od -An -tu1 -j "$place" -N 1 "$1")
    printf "\\x$(printf '%x' $(((byte + 1 + RANDOM % 255) % 256)))" | dd of="$1" bs=1 seek="$place" conv=notrunc status=none
}

# alter KIND: sets `what`, and `named`, the words that verify must use; empty where no generation was altered.
alter() {
    local kind=$1 file
    named=''
    pick tables
    file=$altered/$picked what="$kind in $picked"
    case $kind in
        digit)
            any_row "$file"
            change_digit "$file" 2
            named="generation $generation " ;;
        row-taken)
            any_row "$file"
            edit "$file" 'NR != row { print }' row="$row"
            named="generation $generation " ;;
        row-twice)
            any_row "$file"
            edit "$file" '{ print } NR == row { print }' row="$row"
            named="generation $generation " ;;
        swapped-generations) # the rows of two generations change their places and numbers
            local one two
            any_row "$file" && one=$generation
            any_row "$file" && two=$generation
            edit "$file" '
                function with(line, number) { return number substr(line, index(line, ",")) }
                FNR > 1 && $1 == one { first = first with($0, two) "\n"; next_is = 1 }
                { lines[FNR] = $0; number[FNR] = $1 }
                FNR > 1 && $1 == two { second = second with($0, one) "\n" }
                END {
                    for (i = 1; i <= FNR; ++i)
                        if (i > 1 && number[i] == one) { printf "%s", second; second = "" }
                        else if (i > 1 && number[i] == two) { printf "%s", first; first = "" }
                        else print lines[i]
                }' one="$one" two="$two"
            named="generation $((one < two ? one : two)) " ;;
        header)
            edit "$file" 'NR == 1 { sub(/[a-z]/, "q") } { print }' ;;
        cut-table)
            any_row "$file"
            edit "$file" 'NR < row { print }' row="$row"
            named="generation $generation " ;;
        other-seed)
            cp "$other/$picked" "$file" ;;
        no-file)
            rm "$file" ;;
        chain-digit)
            what='a digit of the chain'
            any_row "$altered/chain.csv"
            change_digit "$altered/chain.csv" 2
            named="generation $generation " ;;
        chain-swap)
            what='two links of the chain'
            local a b
            any_row "$altered/chain.csv" && a=$generation
            any_row "$altered/chain.csv" && b=$generation
            edit "$altered/chain.csv" '
                { lines[NR] = $0; rest[NR] = substr($0, index($0, ",")) }
                END { for (i = 1; i <= NR; ++i) print i == a + 2 ? a rest[b + 2] : i == b + 2 ? b rest[a + 2] : lines[i] }' a="$a" b="$b"
            named="generation $((a < b ? a : b)) " ;;
        chain-cut)
            what='the end of the chain'
            edit "$altered/chain.csv" 'NR < 20 { print }' ;;
        chain-other)
            what='the chain of another seed'
            cp "$other/chain.csv" "$altered/chain.csv"
            named='generation 0 ' ;;
        state-byte | state-cut | state-other)
            local states=(000025 000027)
            pick states
            file=$altered/states/$picked.state what="$kind $picked" named="$picked.state"
            case $kind in
                state-byte) change_byte "$file" ;;
                state-cut) truncate -s $((RANDOM % $(stat -c %s "$file"))) "$file" ;;
                state-other) cp "$other/states/$picked.state" "$file" ;;
            esac ;;
        states-swapped)
            what='two states'
            cp "$whole/states/000025.state" "$altered/states/000027.state"
            cp "$whole/states/000027.state" "$altered/states/000025.state"
            named='000025.state' ;;
        manifest-byte)
            change_byte "$altered/manifest.csv" ;;
        manifest-row)
            any_row "$altered/manifest.csv"
            edit "$altered/manifest.csv" 'NR != row { print }' row="$row" ;;
        manifest-other)
            cp "$other/manifest.csv" "$altered/manifest.csv" ;;
        identity-byte)
            change_byte "$altered/identity.csv" ;;
        identity-other)
            cp "$other/identity.csv" "$altered/identity.csv" ;;
        script)
            local scripts=("$altered"/script/*.lua "$altered"/script/*/*.lua "$altered"/script/overrides.csv)
            pick scripts
            what="$picked"
            change_byte "$picked" ;;
    esac
}
kinds=(digit digit digit digit row-taken row-taken row-twice swapped-generations swapped-generations header cut-table other-seed
       no-file chain-digit chain-digit chain-swap chain-cut chain-other state-byte state-cut state-other states-swapped
       manifest-byte manifest-row manifest-other identity-byte identity-other script script)

done=0 found=0 generations=0 named_right=0
while ((done < alterations)); do
    rm -rf "$altered"
    cp -r "$whole" "$altered"
    alter "${kinds[done % ${#kinds[@]}]}"
    # Two generations may have equal rows, and a row no digit; the same text in other packing is no alteration.
    for table in "${tables[@]}"; do
        if [[ -f $altered/$table ]] && cmp -s <(text_of "$whole/$table") <(text_of "$altered/$table"); then
            cp "$whole/$table" "$altered/$table"
        fi
    done
    if diff -rq "$whole" "$altered" > /dev/null; then continue; fi
    done=$((done + 1)) code=0
    "$program" verify "$altered" --share 0 > "$folder/said" 2>&1 || code=$?
    if ((code == 65)); then
        found=$((found + 1))
    else
        echo "audit: $what: exit code $code" && cat "$folder/said"
    fi
    [[ -n $named ]] || continue
    generations=$((generations + 1))
    if grep -qF "$named" "$folder/said"; then
        named_right=$((named_right + 1))
    else
        echo "audit: $what: verify does not say '$named'" && cat "$folder/said"
    fi
done
echo "audit: $done alterations, $found found, $named_right named the generation"
((found == done && named_right == generations))
