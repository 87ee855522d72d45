#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Finds documentation that names what does not exist. Of every page (*.md; of CHANGELOG.md its first section) it reads
# the code spans, the links and the blocks marked sh, and looks for files, make targets and variables, commands and
# options of planula, and identifiers such as parameters, columns and functions. Of every comment of a source it reads
# the names of files and the numbers of decisions. Prints FILE:LINE: what is wrong; fails if anything is.
#
#   documents.sh [ROOT]     ROOT is the checkout; by default the one this script lies in
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$here/../..}"
export LC_ALL=C
source "$here/files.sh"

mapfile -t all < <(files)
shopt -s nullglob
runs=(data/runs/*/*) # recorded runs, which are not read but may be named
code=() pages=()
for file in "${all[@]}"; do
    case $file in
        # They name on purpose what does not exist.
        tests/lint/*) ;;
        *.md) pages+=("$file") ;;
        *.h | *.cpp | *.inl | *.in | *.lua | *.gp | *.tex | *.sh | *.awk | *.cmake | *.json | *CMakeLists.txt | Makefile | .ci/run | .clang-format) code+=("$file") ;;
    esac
done
((${#pages[@]})) || { echo "documents: no page found in $PWD" >&2; exit 2; }
awk -f "$here/documents.awk" part=files <(printf '%s\n' "${all[@]}" "${runs[@]}") part=code "${code[@]}" part=pages "${pages[@]}"
