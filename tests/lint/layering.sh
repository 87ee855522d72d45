#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The architecture as a check: compares every #include of core/ and scripting/ with the room lines of their
# CMakeLists.txt, both ways; then looks for constructs that are allowed in few places or in none. Comments and the text
# of string literals do not count. Prints FILE:LINE: what is wrong; fails if anything is.
#
#   layering.sh [ROOT]      ROOT is the checkout; by default the one this script lies in
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"

# Folders that hold no source yet are no error, a missing list of rooms is.
lists=(core/CMakeLists.txt scripting/CMakeLists.txt)
for list in "${lists[@]}"; do
    [[ -f $list ]] || { echo "layering: no $list in $PWD" >&2; exit 2; }
done
# scripting/wasm is no room but a program of its own for browsers: it says what its C++ library lacks.
mapfile -t sources < <(find core scripting -path scripting/wasm -prune -o -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.inl' -o -name '*.cu' -o -name '*.cuh' \) -print | LC_ALL=C sort)

LC_ALL=C awk -f tests/lint/layering.awk "${lists[@]}" "${sources[@]}"
