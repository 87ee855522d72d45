#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The gallery of the README: of every file of experiments/variants/ the best body after a small run, its gait and its way.
#
#   gallery.sh PLANULA WORK PICTURES
#
# WORK keeps the runs, so that a second call only draws.
set -euo pipefail
planula=$1 work=$2 pictures=$3
population=60
design=(--seeds 1 --population $population --generations 12)
mkdir -p "$pictures" "$work"
for file in experiments/variants/*.lua; do
    name=$(basename "$file" .lua)
    echo "gallery: $name …" >&2
    "$planula" run "$file" "${design[@]}" --out "$work/$name/runs" 2> "$work-$name.log" || { cat "$work-$name.log" >&2; exit 1; }
    rm "$work-$name.log"
    "$planula" reduce "$file" "${design[@]}" --runs "$work/$name/runs" --out "$work/$name/tables" > /dev/null 2>&1
    "$planula" frames "$file" --set population=$population --data "$work/$name/tables" --out "$work/$name/frames" > /dev/null
    mkdir -p "$work/$name/plan"
    texlua paper/figures/plan.lua "$work/$name/tables" "$work/$name/frames" "$work/$name/runs" "$work/$name/plan" > /dev/null 2>&1
    texlua paper/figures/individuals.lua card "$work/$name/frames" "$work/$name/tables" "$work/$name/plan" "$work/$name/plan/bodies.lua"
    gnuplot -e "layout='$work/$name/plan'; out='$pictures/$name.png'; words = 0; density = 40" paper/figures/page.gp 2> "$work/$name/plan/log" || { cat "$work/$name/plan/log" >&2; exit 1; }
done
echo "gallery: $pictures"
