#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Kills a run at random moments until it has died so many times, damages a checkpoint now and then, and compares what the
# run comes to in the end with one that nobody disturbed. A run that ends too early is compared and begun again.
#
#   kills.sh PROGRAM [KILLS] [SEED]      200 kills, seed 1
set -euo pipefail
cd "$(dirname "$0")/../.."
program=$(realpath "$1") kills=${2:-200}
RANDOM=${3:-1}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# Recurrent networks, an archive, the ground: everything that a run has to remember.
run=("$program" run experiments/paper/replication.lua --only grn-te-ns --seeds 1 --population 12 --generations 25 --checkpoint 2)

compare() {
    diff -r "$folder/whole" "$folder/run" > "$folder/diff" || { echo "kills: the results differ" && cat "$folder/diff" && exit 1; }
    rm -rf "$folder/run"
}

# The undisturbed run also says how long one takes.
began=$(date +%s%N)
"${run[@]}" --out "$folder/whole" > "$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
microseconds=$((($(date +%s%N) - began) / 1000))

killed=0 finished=0 damaged=0
while ((killed < kills)); do
    "${run[@]}" --out "$folder/run" > "$folder/said" 2>&1 &
    child=$!
    moment=$(((RANDOM * 32768 + RANDOM) % (microseconds / 3 + 1)))
    sleep "$(printf '%d.%06d' $((moment / 1000000)) $((moment % 1000000)))"
    kill -KILL "$child" 2> /dev/null || true
    if wait "$child" 2> /dev/null; then
        compare
        finished=$((finished + 1))
        continue
    fi
    # What was not killed must have ended well.
    if [[ -s $folder/said ]] && grep -q '^planula: ' "$folder/said"; then cat "$folder/said"; exit 1; fi
    killed=$((killed + 1))
    checkpoint=$(find "$folder/run" -name checkpoint 2> /dev/null | head -n 1)
    [[ -n $checkpoint ]] && ((RANDOM % 5 == 0)) || continue
    size=$(stat -c %s "$checkpoint")
    if ((RANDOM % 2)); then
        truncate -s $(((RANDOM * 32768 + RANDOM) % size)) "$checkpoint"
    else
        printf '\x5a' | dd of="$checkpoint" bs=1 seek=$(((RANDOM * 32768 + RANDOM) % size)) conv=notrunc status=none
    fi
    damaged=$((damaged + 1))
done
"${run[@]}" --out "$folder/run" > "$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
compare
echo "kills: $killed kills, $damaged damaged checkpoints, $((finished + 1)) runs to the end, all as the undisturbed one"
