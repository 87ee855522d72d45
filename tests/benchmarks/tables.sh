#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes results.csv and multineat.csv in this folder, row by row. A row that was finished is kept, so that an
# interrupted call goes on where it was, as long as the programs and the number of runs are the same.
#
#   tables.sh PROGRAMS RUNS KEPT     folders of the programs and of the finished rows; seeds 1 … RUNS
set -euo pipefail
(($# == 3)) || { echo "usage: tables.sh PROGRAMS RUNS KEPT" >&2; exit 2; }
programs=$1 runs=$2 here=$(dirname "$0")
kept=$3/$(cat "$programs/benchmarks" "$programs/multineat" | sha256sum | cut -c 1-16)-$runs
mkdir -p "$kept"

# part FILE COMMAND…: the file holds what the command prints, once it has ended well.
part() {
    local file=$1
    shift
    [[ -f $file ]] || { "$@" > "$file.new" && mv "$file.new" "$file"; }
}

parts=()
for row in $("$programs/benchmarks" rows); do
    file=$kept/${row//\//,}.csv
    part "$file" "$programs/benchmarks" 1 "$runs" "$row"
    tail -n +2 "$file"
    parts+=("$file")
done
part "$kept/multineat.csv" "$programs/multineat" 1 "$runs"
awk 'FNR > 1 || NR == 1' "${parts[@]}" > "$here/results.csv"
cp "$kept/multineat.csv" "$here/multineat.csv"
echo "benchmarks: $here/results.csv, $here/multineat.csv"
