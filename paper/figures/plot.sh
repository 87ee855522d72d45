#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the figures of any experiment, in the style of the article: `make figures` with RUNS or another EXPERIMENT.
#
#   plot.sh PLANULA RUNS OUT "FORMATS" [EXPERIMENT]
#
# RUNS is a folder of runs. Its runs keep their script, which is used unless EXPERIMENT names one, as one with other titles.
# All runs are shown as they were after the generations that all of them have. Writes into OUT tables, and each figure in
# each of the formats pdf, svg and png that are named.
set -euo pipefail
planula=$1 runs=$2 out=$3 formats=$4 experiment=${5:-}
fail() { echo "figures: $1" >&2; exit 1; }
[[ -d $runs ]] || fail "there is no folder $runs; planula run writes one, with --out"
case $out in *"'"*) fail "the name of a folder for figures must not hold a quotation mark: $out" ;; esac

# The complete runs, their script, what the command line set beside it, and their shortest length.
mapfile -t complete < <(find "$runs" -mindepth 3 -maxdepth 3 -name manifest.csv -path '*/seed-*/*' | sort)
((${#complete[@]})) || fail "$runs has no complete run (<setting>/seed-NNN/manifest.csv); planula status $runs says how far they are"
folder=$(dirname "${complete[0]}")
if [[ -z $experiment ]]; then
    for manifest in "${complete[@]}"; do
        cmp -s "$folder/script/experiment.lua" "$(dirname "$manifest")/script/experiment.lua" ||
            fail "$runs has runs of different scripts, as $folder and $(dirname "$manifest"); say which to show: EXPERIMENT=FILE.lua"
    done
    experiment=$folder/script/experiment.lua
fi
changes=()
while IFS=, read -r name value; do changes+=(--set "$name=$value"); done < <(grep -v '^generations,' "$folder/script/overrides.csv" | tail -n +2)
generations=$(awk -F, '$1 == "generations" { print $2 }' "${complete[@]}" | sort -n | head -n 1)

mkdir -p "$out/plan"
echo "figures: reducing ${#complete[@]} runs after $generations generations …" >&2
"$planula" reduce "$experiment" "${changes[@]}" --generations "$generations" --runs "$runs" --out "$out/tables" > /dev/null
"$planula" frames "$experiment" "${changes[@]}" --data "$out/tables" --out "$out/frames" > /dev/null

figures=$(texlua paper/figures/plan.lua "$out/tables" "$out/frames" "$runs" "$out/plan")
draw() { # FILE SCRIPT: gnuplot's warnings, as of a setting without data, are shown only if it fails
    gnuplot -e "data='$out/tables'; layout='$out/plan'; out='$1'" "$2" 2> "$out/plan/log" || { cat "$out/plan/log" >&2; fail "gnuplot could not draw $1"; }
    # For a line without data gnuplot writes a point of size 0 into an SVG, which librsvg refuses.
    LC_ALL=C sed -i -e "/<use .* scale(0\.00)/d" -e 's/^\( *\/CreationDate (D:\)[0-9]*[^)]*/\120151217000000Z/' "$1" # the date of the day
}
for figure in $figures; do
    script=$out/plan/$figure.gp
    if [[ $figure == bodies ]]; then
        texlua paper/figures/individuals.lua bodies "$out/frames" "$out/tables" "$out/plan" "$out/plan/bodies.lua"
        script=paper/figures/page.gp
    fi
    for ending in $formats; do draw "$out/$figure.$ending" "$script"; done
done
echo "figures: $(wc -w <<< "$figures"), each as ${formats// /, }, in $out"
