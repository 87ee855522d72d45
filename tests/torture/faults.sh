#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes each system call for files that a command makes fail once: disk full, input or output error, too many open
# files, permission denied. A command that exits with 0 must have the right results; any other must name a file, and
# when it is run once more it must reach the right results without repeating what was complete or saved. The commands: a
# run from its beginning and after a kill, a complete run that is continued, a merge into an empty folder and over a
# shorter run, and reduce. Needs strace.
#
#   faults.sh PROGRAM [EVERY]      every EVERYth call; 1: all of them
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v strace > /dev/null || { echo 'faults: skipped, strace is not installed'; exit 0; }
program=$(realpath "$1") every=${2:-1}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
script=experiments/paper/replication.lua
design=(--only osc-aq-ns --population 6 --set development_steps=200 --set locomotion_steps=100 --threads 1)
run=("$program" run $script "${design[@]}" --checkpoint 1)
out=$folder/out

"${run[@]}" --seeds 1 --generations 4 --out "$folder/whole" 2> /dev/null
"${run[@]}" --seeds 1 --generations 2 --out "$folder/shorter" 2> /dev/null
"${run[@]}" --seeds 1:2 --generations 4 --out "$folder/two" 2> /dev/null
reduce=("$program" reduce $script --population 6 --generations 4 --set development_steps=200 --set locomotion_steps=100)
"${reduce[@]}" --runs "$folder/two" --out "$folder/tables" > /dev/null
# A run that was killed after its first checkpoints.
until [[ -d $folder/killed ]]; do
    rm -rf "$folder/begun"
    "${run[@]}" --seeds 1 --generations 4 --out "$folder/begun" 2> /dev/null &
    child=$!
    until [[ -n $(find "$folder/begun" -name checkpoint.previous 2> /dev/null) ]] || ! kill -0 "$child" 2> /dev/null; do :; done
    kill -KILL "$child" 2> /dev/null || true
    wait "$child" 2> /dev/null || mv "$folder/begun" "$folder/killed"
done

# Each job: the files before, the files expected after, and the command.
declare -A first=([begin]='' [resume]=killed [longer]=shorter [merge]='' [replace]=shorter [reduce]='')
declare -A last=([begin]=whole [resume]=whole [longer]=whole [merge]=whole [replace]=whole [reduce]=tables)
command_of() { # command_of JOB: sets `words`
    case $1 in
        begin | resume | longer) words=("${run[@]}" --seeds 1 --generations 4 --out "$out") ;;
        merge | replace) words=("$program" merge "$folder/whole" --into "$out") ;;
        reduce) words=("${reduce[@]}" --runs "$folder/two" --out "$out") ;;
    esac
}
set_out() {
    rm -rf "$out"
    if [[ -n ${first[$job]} ]]; then cp -r "$folder/${first[$job]}" "$out"; fi
}
# The progress file of a running process is not a result.
is_right() { diff -rq -x progress "$folder/${last[$job]}" "$out" > "$folder/diff" 2>&1; }

places=0 failed=0 bad=0
complain() { # complain WHAT
    echo "faults: $job, $call $error $place: $1"
    bad=$((bad + 1))
}
try() { # try JOB CALL ERROR PLACE
    job=$1 call=$2 error=$3 place=$4
    local code=0
    command_of "$job"
    set_out
    places=$((places + 1))
    strace -f -qq -o /dev/null -e trace="$call" -e inject="$call:error=$error:when=$place" "${words[@]}" \
        > "$folder/said" 2>&1 || code=$?
    if ((code == 0)); then
        is_right || complain "done, and the results are wrong: $(head -n 3 "$folder/diff")"
    else
        failed=$((failed + 1))
        grep -qE '/|\.lua|\.so|standard output' "$folder/said" || complain "exit code $code, and no file is named: $(tail -n 1 "$folder/said")"
        ((code == 65 || code == 73 || code == 74 || code == 127)) || complain "exit code $code: $(tail -n 1 "$folder/said")"
    fi
    "${words[@]}" > "$folder/said" 2>&1 || complain "does not end right when repeated: $(tail -n 1 "$folder/said")"
    is_right || complain "comes to wrong results: $(head -n 3 "$folder/diff")"
    case $job in
        resume | longer) grep -qE 'resumes with generation|generations already' "$folder/said" || complain 'started from the beginning' ;;
    esac
}
kinds=(write:ENOSPC fsync:EIO rename:EIO renameat2:EINVAL renameat2:EIO ftruncate:EIO flock:ENOLCK close:EIO unlink:EIO
       unlinkat:EIO read:EIO mkdir:EACCES newfstatat:EIO openat:ENOSPC openat:EMFILE openat:EIO openat:EACCES)
number=0
for job in begin resume longer merge replace reduce; do
    for kind in "${kinds[@]}"; do
        command_of "$job"
        set_out
        strace -f -qq -o "$folder/calls" -e trace="${kind%:*}" "${words[@]}" > /dev/null 2>&1
        calls=$(grep -c "${kind%:*}(" "$folder/calls" || true)
        for ((place = 1; place <= calls; place++)); do
            number=$((number + 1))
            ((number % every == 0)) || continue
            try "$job" "${kind%:*}" "${kind#*:}" "$place"
        done
    done
done
echo "faults: $places calls failed once each, $failed commands ended with an error, $bad had wrong results"
((bad == 0))
