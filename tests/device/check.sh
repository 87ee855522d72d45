#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The check of a graphics processor, ten minutes at most: are all bits those of the native engine, how fast is it, and
# what limits it. `make device-files` builds what it needs; on the machine with the device it compiles nothing and needs
# the driver alone. Profile and sanitizer are run where they are installed. Changes no setting of the device.
#
#   check.sh [FILES] [OUT]     FILES: the folder that `make device-files` made (default: build/device)
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
export LC_ALL=C
files=$(realpath "${1:-build/device}") out=${2:-build/device-check}
planula=$files/planula
[[ -x $planula ]] || { echo "check: no program in $files; run make device-files"; exit 1; }
export LD_LIBRARY_PATH=$files/lib:${LD_LIBRARY_PATH-}
mkdir -p "$out"
passed=0 failed=0
note() { echo "$*" | tee -a "$out/summary.txt"; }
# check NAME COMMAND…: counts, notes the time and the last line, and keeps the whole output.
check() {
    local name=$1 code=0 start=$SECONDS
    "${@:2}" > "$out/$name.txt" 2>&1 || code=$?
    if ((code == 0)); then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    note "$name: $([[ $code == 0 ]] && echo passed || echo "FAILED, exit code $code") in $((SECONDS - start)) s: $(tail -n 1 "$out/$name.txt")"
    return "$code"
}
: > "$out/summary.txt"
note "machine: $(nproc) processors, $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1)"
if command -v nvidia-smi > /dev/null; then
    note "device: $(nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv,noheader | head -n 1)"
    nvidia-smi --query-gpu=timestamp,power.draw,clocks.sm,utilization.gpu,temperature.gpu --format=csv -lms 500 > "$out/power.csv" 2>&1 &
    power=$!
    trap 'kill $power 2> /dev/null' EXIT
fi

same_signature() { diff <(timeout 120 "$planula" signature --device gpu) tests/golden/signature && echo 'the signature is that of tests/golden'; }
check signature same_signature || { note 'nothing else is checked'; exit 1; }

# Recorded lives of 30 generations of all settings, each simulated again.
check evolved timeout 200 "$planula" verify data/runs/replication --share 100 --draw 1 --minutes 2 --device gpu

check bench timeout 150 "$files/device_bench" 1
column -s, -t "$out/bench.txt" 2> /dev/null || cat "$out/bench.txt"
if awk -F, 'NR > 1 && $7 > 0 { exit 1 }' "$out/bench.txt"; then note 'bench: no trial differs'; else note 'bench: trials DIFFER'; failed=$((failed + 1)); fi

# Whole evolution, growth included: on processors, on the device, and half on each.
evolve() { timeout 100 "$planula" run experiments/paper/replication.lua --seeds 1:2 --population 300 --generations "$1" --out "$out/$2" "${@:3}"; }
mixed() { evolve 3 mixed --device gpu && evolve 6 mixed --device cpu; }
check run_cpu evolve 6 cpu
check run_gpu evolve 6 gpu --device gpu
check run_mixed mixed
equal_runs() {
    local chain count=0
    for chain in "$out"/cpu/*/*/chain.csv; do
        for device in gpu mixed; do cmp "$chain" "${chain/"$out/cpu"/"$out/$device"}" || return 1; done
        count=$((count + 1))
    done
    echo "$count chains of each are equal"
    ((count > 0))
}
check equal_runs equal_runs
rm -rf "$out/cpu" "$out/gpu" "$out/mixed"

if command -v ncu > /dev/null; then
    check profile timeout 120 ncu --clock-control none --launch-count 1 --section SpeedOfLight --section SchedulerStats \
        --section WarpStateStats --section Occupancy --section LaunchStats --section InstructionStats "$files/device_bench" --once 1024
    grep -E 'Issue Slots Busy|Issued Warp|Registers Per|Achieved Occupancy|Eligible Warps|Duration' "$out/profile.txt" | tee -a "$out/summary.txt"
fi
if command -v compute-sanitizer > /dev/null; then
    for tool in memcheck racecheck synccheck; do
        check "$tool" timeout 60 compute-sanitizer --tool "$tool" --error-exitcode 9 "$files/device_bench" --once 1
    done
fi
[[ -f $out/power.csv ]] && note "power: $(awk -F', ' 'NR > 1 && $2 + 0 > most { most = $2 + 0 } END { print most }' "$out/power.csv") W at most"
note "device: $passed passed, $failed failed"
((failed == 0))
