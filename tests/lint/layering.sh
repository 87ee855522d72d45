#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The architecture as a check: reads the room lines of core/CMakeLists.txt and compares every #include of core/ with
# them; then looks for constructs that may stand in few places or in none. Comments and the text of string literals do
# not count. Prints FILE:LINE: what is wrong; fails if anything is.
#
#   layering.sh [ROOT]      ROOT is the checkout; by default the one this script lies in
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"

# Folders that hold no source yet are no error, a missing list of rooms is.
[[ -f core/CMakeLists.txt ]] || { echo "layering: no core/CMakeLists.txt in $PWD" >&2; exit 2; }
mapfile -t sources < <(find core scripting -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.inl' \) | LC_ALL=C sort)

LC_ALL=C awk -f tests/lint/layering.awk core/CMakeLists.txt "${sources[@]}"
