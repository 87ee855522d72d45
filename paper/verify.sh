#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks the tracked data: that every run in data/runs/ agrees with itself, that a random part of them is what simulation
# gives, that the tables in data/ follow from these runs, and that a random part of those that need simulation, the
# witness's and the sensitivity's, is right.
#
#   verify.sh PROGRAM FOLDER MINUTES      FOLDER takes what is made on the way
#
# Prints what it does; its last line counts the checks. Fails if one does.
set -euo pipefail
cd "$(dirname "$0")/.."
program=$1 folder=$2 minutes=$3
passed=0 failed=0
[[ -f data/manifest.csv ]] || { echo 'verify: there are no tracked tables in data/' >&2; exit 1; }
rm -rf "$folder"
mkdir -p "$folder"

# stated KEY: what data/manifest.csv says.
stated() { awk -F, -v key="$1" '$1 == key { print $2 }' data/manifest.csv; }
design=(--population "$(stated population)" --generations "$(stated generations)")

check() { # check WHAT COMMAND…
    local what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        echo "verify: $what: right"
    else
        failed=$((failed + 1))
        echo "verify: $what: WRONG"
    fi
}

# The tables that reduce makes of the runs, each as it is tracked.
tables() {
    "$program" reduce experiments/paper/replication.lua "${design[@]}" --seeds "1:$(stated seeds)" --runs data/runs/replication \
        --out "$folder/data" > /dev/null
    "$program" reduce experiments/searches.lua --runs data/runs/searches --out "$folder/searches" > /dev/null
    cp "$folder/searches/runs.csv" "$folder/data/searches.csv"
    local table wrong=0
    for table in "$folder"/data/*.csv; do
        cmp "$table" "data/${table##*/}" || wrong=1
    done
    return "$wrong"
}

# Every champion of one seed, simulated again at finer steps and in Bullet.
witness() {
    local seed=$((RANDOM % $(stated seeds) + 1))
    "$program" witness experiments/paper/replication.lua "${design[@]}" --seeds "$seed" --runs data/runs/replication \
        --out "$folder/witness" > /dev/null
    diff <(sort "$folder/witness/witness.csv") <(awk -F, -v seed="$seed" 'NR == 1 || $2 == seed' data/witness.csv | sort)
}

# One assumed value, halved and doubled.
sensitivity() {
    local parameter
    parameter=$(awk -F, 'NR > 1 { print $2 }' data/sensitivity.csv | sort -u | shuf -n 1)
    "$program" sensitivity experiments/sensitivity.lua --parameter "$parameter" --runs data/runs/replication \
        --out "$folder/sensitivity" > /dev/null 2> "$folder/sensitivity.log" || { cat "$folder/sensitivity.log"; return 1; }
    echo "verify: $parameter"
    diff "$folder/sensitivity/sensitivity.csv" <(awk -F, -v name="$parameter" 'NR == 1 || $2 == name' data/sensitivity.csv)
}

check 'the tables follow from the runs' tables
check 'the champions of one seed' witness
check 'the sensitivity to one value' sensitivity
check 'the runs' "$program" verify data/runs --share 100 --minutes "$minutes"
echo "verify: $passed passed, $failed failed"
((failed == 0))
