#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compares `planula signature`, one hash over the runs of experiments/signature.lua, with tests/golden/signature, and
# the latter with the hash that the program was built with, its model revision.
#
#   signature.sh PROGRAM          this program, as it is
#   signature.sh --alternative    another build: by clang++ where it is installed, else by g++ without optimisation
#   signature.sh --all            each compiler × {-O0, -O3} × {1, 2, 3, 7 threads} × {this processor, one whose libc
#                                 sees neither AVX2 nor FMA}, and each width of lanes
#
# Prints one line per cell of that table and a last one that counts; fails if a cell differs.
set -euo pipefail
cd "$(dirname "$0")/../.."
golden=tests/golden/signature
script=experiments/signature.lua
plain_libm='glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable'
jobs=${JOBS:-$(nproc)}
passed=0 failed=0
[[ -s $golden ]] || { echo "signature: $golden is missing" >&2; exit 1; }

# build COMPILER LEVEL [OPTION…]: prints the program's path, having built it.
build() {
    local folder=build/signature/$1$2
    mkdir -p "$folder"
    [[ -f $folder/CMakeCache.txt ]] ||
        cmake -S . -B "$folder" -DCMAKE_CXX_COMPILER="$1" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$2" -DBUILD_TESTING=OFF \
            "${@:3}" > "$folder/log" 2>&1 || { cat "$folder/log" >&2; return 1; }
    cmake --build "$folder" --parallel "$jobs" --target planula > "$folder/log" 2>&1 || { cat "$folder/log" >&2; return 1; }
    echo "$folder/planula"
}

# cell TITLE COMMAND…: runs one cell.
cell() {
    local title=$1 value
    shift
    value=$("$@" 2>&1) || true
    if [[ $value == "$(< "$golden")" ]]; then
        passed=$((passed + 1))
        echo "signature: $title: as in $golden"
    else
        failed=$((failed + 1))
        printf 'signature: %s: DIFFERS\n  expected %s\n  got      %s\n' "$title" "$(< "$golden")" "$value"
    fi
}

# stated TITLE PROGRAM: one cell, the signature that the program states.
stated() { cell "$1, as compiled in" "$2" signature --compiled; }

case ${1-} in
    --alternative)
        compiler=g++ level=-O0
        if command -v clang++ > /dev/null; then compiler=clang++ level=-O1; fi
        program=$(build "$compiler" "$level")
        stated "$compiler $level" "$program"
        cell "$compiler $level" "$program" signature --script "$script" --threads "$jobs"
        ;;
    --all)
        for compiler in g++ clang++; do
            command -v "$compiler" > /dev/null || { echo "signature: $compiler is not installed, left out"; continue; }
            for level in -O0 -O3; do
                # Each source must include what it uses, which precompiled headers would hide.
                program=$(build "$compiler" "$level" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)
                stated "$compiler $level" "$program"
                for lanes in scalar sse2 avx2 avx512; do
                    # A processor that lacks these lanes says so.
                    "$program" signature --lanes "$lanes" --script /dev/null 2>&1 | grep -q 'no lanes' ||
                        cell "$compiler $level, $lanes" "$program" signature --script "$script" --lanes "$lanes"
                done
                for threads in 1 2 3 7; do
                    cell "$compiler $level, $threads threads" "$program" signature --script "$script" --threads "$threads"
                    cell "$compiler $level, $threads threads, no AVX2, no FMA" \
                        env GLIBC_TUNABLES="$plain_libm" "$program" signature --script "$script" --threads "$threads"
                done
            done
        done
        ;;
    -* | '')
        echo "usage: signature.sh PROGRAM | --alternative | --all" >&2
        exit 2
        ;;
    *)
        stated "$1" "$1"
        cell "$1" "$1" signature --script "$script"
        ;;
esac
echo "signature: $passed passed, $failed failed"
((failed == 0))
