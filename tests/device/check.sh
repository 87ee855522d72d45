#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The check of a graphics processor, nine minutes at most: are all bits those of the native engine, how fast is it, and
# what limits it. `make device-files` builds what it needs; on the machine with the device it compiles nothing and needs
# the driver alone. Profile and sanitizer are run where they are installed. Changes no setting of the device.
#
#   check.sh [FILES] [OUT] [SECONDS]     FILES: the folder that `make device-files` made (default: build/device)
#                                        SECONDS: what is not done by then is left out (default: 520)
#
# The most important comes first, and each part is in OUT (default: build/device-check) as soon as it is done:
# summary.txt, log.txt with all that the parts said, bench.csv, pipeline.csv, profile.txt, power.csv.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
export LC_ALL=C
files=$(realpath "${1:-build/device}") out=${2:-build/device-check} seconds=${3:-520}
planula=$files/bin/planula bench=$files/bin/device_bench
[[ -x $planula && -x $bench ]] || { echo "check: no programs in $files; run make device-files"; exit 1; }
mkdir -p "$out" || exit 1
work=$(mktemp -d)
power=
finish() { [[ $power ]] && kill "$power" 2> /dev/null; rm -rf "$work"; }
trap finish EXIT
trap 'exit 143' TERM INT
: > "$out/summary.txt"
: > "$out/log.txt"
passed=0 failed=0 left_out=0
note() { echo "$*" | tee -a "$out/summary.txt"; }

# The libraries of FILES are for its programs alone. Those of the compiler come from the machine, if they are new enough.
with_libraries() { own=(/usr/bin/env "LD_LIBRARY_PATH=$1${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"); }
with_libraries "$files/lib"
"${own[@]}" "$planula" --version > /dev/null 2>&1 || with_libraries "$files/lib:$files/lib/compiler"
"${own[@]}" "$planula" --version > "$out/log.txt" 2>&1 || { note "check: the program does not start here: $(tail -n 1 "$out/log.txt")"; exit 1; }

# within LIMIT COMMAND…: as long, or as long as there is time.
within() {
    local limit=$1 left=$((seconds - SECONDS))
    timeout -k 5 "$((left < limit ? left : limit))" "${@:2}"
}
# check NAME FILE COMMAND…: counts, notes the time and the last line; what it prints is in FILE, and in the log.
check() {
    local name=$1 file=$2 code=0 start=$SECONDS
    if ((seconds - SECONDS < 10)); then left_out=$((left_out + 1)); note "$name: left out, no time"; return 1; fi
    "${@:3}" > "$file" 2>&1 || code=$?
    { echo "== $name"; cat "$file"; } >> "$out/log.txt"
    if ((code == 0)); then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    note "$name: $(case $code in 0) echo passed ;; 124 | 137) echo 'FAILED, stopped' ;; *) echo "FAILED, exit code $code" ;; esac) after $((SECONDS - start)) s: $(tail -n 1 "$file")"
    return "$code"
}
finish_summary() {
    [[ -f $out/power.csv ]] && note "power: $(awk -F', ' 'NR > 1 && $2 + 0 > most { most = $2 + 0 } END { print most + 0 }' "$out/power.csv") W at most"
    note "device: $passed passed, $failed failed, $left_out left out, in $SECONDS s"
    printf '\n== Summary\n'
    cat "$out/summary.txt"
    ((failed == 0)) && exit 0
    exit 1
}
show() { column -s, -t "$1" 2> /dev/null || cat "$1"; }

note "machine: $(nproc) processors, $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1), $(lscpu 2> /dev/null | sed -n 's/^Thread(s) per core: */threads per core: /p')"
if command -v nvidia-smi > /dev/null; then
    note "device: $(nvidia-smi --query-gpu=name,driver_version,memory.total,clocks.max.sm --format=csv,noheader 2>&1 | head -n 1)"
    nvidia-smi --query-gpu=timestamp,power.draw,clocks.sm,utilization.gpu,temperature.gpu --format=csv -lms 500 > "$out/power.csv" 2>&1 &
    power=$!
fi

# ---- Bits ------------------------------------------------------------------------------------------------------------
same_signature() {
    local found
    found=$(within 60 "${own[@]}" "$planula" signature --device gpu) || return
    [[ $found == "$(cat tests/golden/signature)" ]] || { echo "the signature is $found, not that of tests/golden"; return 1; }
    echo 'the signature is that of tests/golden'
}
check signature "$work/signature" same_signature
code=$?
if ((code)); then
    # Where a device was found: what differs, and whether memory is misused.
    ((code == 2)) || check diagnosis "$out/bench.csv" within 60 "${own[@]}" "$bench" 0.1
    ((code == 2)) || ! command -v compute-sanitizer > /dev/null ||
        check memcheck "$work/memcheck" within 60 compute-sanitizer --target-processes all --error-exitcode 9 "${own[@]}" "$bench" --launch 1
    note 'nothing else is checked'
    finish_summary
fi

# Recorded lives of a run of each setting, simulated again.
check recorded "$work/recorded" within 100 "${own[@]}" "$planula" verify "$files/runs/replication" --share 100 --draw 1 --minutes 1 --device gpu
grep '^verify:' "$work/recorded" | tee -a "$out/summary.txt"

# ---- Speed -----------------------------------------------------------------------------------------------------------
check bench "$out/bench.csv" within 110 "${own[@]}" "$bench" 0.5
show "$out/bench.csv"
check pipeline "$out/pipeline.csv" within 50 "${own[@]}" "$bench" --pipeline 0.7
show "$out/pipeline.csv"
# The same where each batch has a queue of its own.
check queues "$work/queues" within 40 "${own[@]}" CUDA_DEVICE_MAX_CONNECTIONS=32 "$bench" --pipeline 0.4
show "$work/queues"

# Whole evolution, growth included: on processors, on the device, and half on each.
evolve() {
    local start=${EPOCHREALTIME/./}
    within 90 "${own[@]}" "$planula" run experiments/paper/replication.lua --seeds 1:4 --population 300 --generations "$1" --out "$work/$2" "${@:3}" || return
    echo "$((8 * 4 * 300 * $1 * 1000000 / (${EPOCHREALTIME/./} - start))) lives a second"
}
mixed() { evolve 6 mixed --device gpu && evolve 12 mixed --device cpu; }
check run_cpu "$work/run_cpu" evolve 12 cpu
check run_gpu "$work/run_gpu" evolve 12 gpu --device gpu
check run_mixed "$work/run_mixed" mixed
equal_runs() {
    local chain count=0
    for chain in "$work"/cpu/*/*/chain.csv; do
        for device in gpu mixed; do cmp "$chain" "${chain/"$work/cpu"/"$work/$device"}" || return 1; done
        count=$((count + 1))
    done
    echo "$count chains of each are equal"
    ((count > 0))
}
check equal_runs "$work/equal_runs" equal_runs

# ---- Where the time goes ---------------------------------------------------------------------------------------------
if command -v ncu > /dev/null; then
    sections=(SpeedOfLight ComputeWorkloadAnalysis SchedulerStats WarpStateStats Occupancy LaunchStats InstructionStats MemoryWorkloadAnalysis)
    check profile "$out/profile.txt" within 90 ncu --clock-control none --target-processes all --launch-count 1 "${sections[@]/#/--section=}" "${own[@]}" "$bench" --launch 2112
    grep -E 'Duration|Issue Slots Busy|Issued Warp|No Eligible|Registers Per|Achieved Occupancy|Theoretical Occupancy|Eligible Warps|Executed Ipc|Block Limit' "$out/profile.txt" | tee -a "$out/summary.txt"
fi
if command -v compute-sanitizer > /dev/null; then
    for tool in memcheck synccheck racecheck; do
        check "$tool" "$work/$tool" within 50 compute-sanitizer --target-processes all --tool "$tool" --error-exitcode 9 "${own[@]}" "$bench" --launch 2
    done
fi
finish_summary
