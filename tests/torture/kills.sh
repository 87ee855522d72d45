#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Kills a run at random moments, the given number of times, with another length asked for each time and a checkpoint
# damaged now and then. Every run that is completed must equal an undisturbed run of its length; then it is started from
# generation 0 again. After that it kills `planula merge`, a quarter as often.
#
#   kills.sh PROGRAM [KILLS] [SEED]      200 kills, seed 1
set -euo pipefail
cd "$(dirname "$0")/../.."
program=$(realpath "$1") kills=${2:-200}
RANDOM=${3:-1}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# Recurrent networks, an archive, the ground: everything that a run has to save. States before generations 25 and 50 are
# kept.
lengths=(5 12 26 27 51 60)
setting=grn-te-ns
run=("$program" run experiments/paper/replication.lua --only $setting --seeds 1 --population 12 --checkpoint 2
     --set development_steps=200 --set locomotion_steps=100)
place=$folder/run/$setting/seed-001

# whole LENGTH: the folder of an undisturbed run, which is made once.
whole() {
    [[ -d $folder/whole-$1 ]] || "${run[@]}" --generations "$1" --out "$folder/whole-$1" > "$folder/said" 2>&1 || { cat "$folder/said" >&2; exit 1; }
    echo "$folder/whole-$1"
}
compare() { # compare WHOLE FOLDER
    diff -rq "$1" "$2" > "$folder/diff" || { echo "kills: the results differ" && cat "$folder/diff" && exit 1; }
}
wait_some() { # wait_some MICROSECONDS: a random part of these
    local moment=$(((RANDOM * 32768 + RANDOM) % ($1 + 1)))
    sleep "$(printf '%d.%06d' $((moment / 1000000)) $((moment % 1000000)))"
}
# killed_or_done PROCESS: kills it; 0 if it had already ended without an error.
killed_or_done() {
    local code=0
    kill -KILL "$1" 2> /dev/null || true
    wait "$1" 2> /dev/null || code=$?
    ((code == 0 || code == 137)) || { echo "kills: exit code $code"; cat "$folder/said"; exit 1; }
    return $((code != 0))
}
stated_length() { awk -F, '$1 == "generations" { print $2 }' "$place/manifest.csv"; }

# The undisturbed run also says how long one takes.
began=$(date +%s%N)
whole "${lengths[-1]}" > /dev/null
microseconds=$((($(date +%s%N) - began) / 1000))

killed=0 compared=0 damaged=0 longer=0
while ((killed < kills)); do
    length=${lengths[RANDOM % ${#lengths[@]}]}
    [[ -f $place/manifest.csv ]] && (($(stated_length) < length)) && longer=$((longer + 1))
    "${run[@]}" --generations "$length" --out "$folder/run" > "$folder/said" 2>&1 &
    child=$!
    wait_some $((microseconds / 2))
    if killed_or_done $child; then
        "$program" verify "$folder/run" --share 0 > "$folder/said" 2>&1 || { echo 'kills: verify fails'; cat "$folder/said"; exit 1; }
        # A longer run that was unfinished still is.
        [[ -f $place/checkpoint || -f $place/checkpoint.previous ]] && continue
        length=$(stated_length)
        compare "$(whole "$length")" "$folder/run"
        compared=$((compared + 1))
        if ((length >= lengths[-1])); then rm -rf "$folder/run"; fi
        continue
    fi
    killed=$((killed + 1))
    checkpoint=$place/checkpoint
    [[ -f $checkpoint && -f $checkpoint.previous ]] && ((RANDOM % 5 == 0)) || continue
    size=$(stat -c %s "$checkpoint")
    if ((RANDOM % 2)); then
        truncate -s $(((RANDOM * 32768 + RANDOM) % size)) "$checkpoint"
    else
        printf '\x5a\xa5' | dd of="$checkpoint" bs=1 seek=$(((RANDOM * 32768 + RANDOM) % size)) conv=notrunc status=none
    fi
    damaged=$((damaged + 1))
done
"${run[@]}" --generations "${lengths[-1]}" --out "$folder/run" > "$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
compare "$(whole "$(stated_length)")" "$folder/run"

merges=0
began=$(date +%s%N)
"$program" merge "$(whole 60)" --into "$folder/into" > /dev/null
microseconds=$((($(date +%s%N) - began) / 1000))
while ((merges < kills / 4)); do
    rm -rf "$folder/into"
    # Into an empty folder, and over a shorter run.
    if ((RANDOM % 2)); then cp -r "$(whole 27)" "$folder/into"; fi
    for again in 1 2 3; do
        "$program" merge "$(whole 60)" --into "$folder/into" > "$folder/said" 2>&1 &
        child=$!
        wait_some "$microseconds"
        if killed_or_done $child; then break; fi
        merges=$((merges + 1))
    done
    "$program" merge "$(whole 60)" --into "$folder/into" > "$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
    compare "$(whole 60)" "$folder/into"
done
echo "kills: $killed kills of runs, $longer while a complete run was continued, $damaged damaged checkpoints, $((compared + 1)) completed runs equal to undisturbed ones; $merges kills of merges"
