#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Lets every single call of the system that a run makes for its files fail once: with a full disk, with a broken one. A run
# that says it is done must have the right results, any other must name a file, and the same command must go on afterwards to
# the right results. Every second case starts from a run that was killed in the middle. Needs strace.
#
#   faults.sh PROGRAM
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v strace > /dev/null || { echo 'faults: skipped, strace is not installed'; exit 0; }
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
run=("$program" run experiments/paper/replication.lua --only osc-aq-ns --seeds 1 --population 6 --generations 6 --checkpoint 1
     --set development_steps=200 --set locomotion_steps=100)

"${run[@]}" --out "$folder/whole" 2> /dev/null
# A run that was killed once its first checkpoints were there.
until [[ -d $folder/killed ]]; do
    rm -rf "$folder/begun"
    "${run[@]}" --out "$folder/begun" 2> /dev/null &
    child=$!
    until [[ -n $(find "$folder/begun" -name checkpoint.previous 2> /dev/null) ]] || ! kill -0 "$child" 2> /dev/null; do :; done
    kill -KILL "$child" 2> /dev/null || true
    wait "$child" 2> /dev/null || mv "$folder/begun" "$folder/killed"
done

places=0 failed=0 bad=0
complain() { # complain WHAT
    echo "faults: $call $error $place: $1"
    bad=$((bad + 1))
}
set_out() {
    rm -rf "$folder/out"
    if ((place % 2)); then cp -r "$folder/killed" "$folder/out"; fi
}
for kind in write:ENOSPC fsync:EIO rename:EIO ftruncate:EIO flock:ENOLCK openat:ENOSPC close:EIO unlink:EIO read:EIO; do
    call=${kind%:*} error=${kind#*:}
    place=1
    set_out
    strace -f -o "$folder/calls" -e trace="$call" "${run[@]}" --out "$folder/out" 2> /dev/null
    calls=$(grep -c "$call(" "$folder/calls" || true)
    for ((place = 1; place <= calls; place++)); do
        set_out
        places=$((places + 1)) code=0
        strace -f -o /dev/null -e trace="$call" -e inject="$call:error=$error:when=$place" "${run[@]}" --out "$folder/out" \
            > /dev/null 2> "$folder/said" || code=$?
        if ((code == 0)); then
            diff -r "$folder/whole" "$folder/out" > /dev/null || complain 'done, and the results are wrong'
        else
            failed=$((failed + 1))
            grep -qE '/|\.lua|\.so' "$folder/said" || complain "exit code $code, and no file is named: $(tail -n 1 "$folder/said")"
        fi
        "${run[@]}" --out "$folder/out" 2> "$folder/said" || complain "does not go on: $(tail -n 1 "$folder/said")"
        diff -r "$folder/whole" "$folder/out" > /dev/null || complain 'goes on to wrong results'
    done
done
echo "faults: $places calls failed once each, $failed runs ended with an error, $bad were not as they must be"
((bad == 0))
