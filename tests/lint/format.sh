#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Whether every C++ source is as clang-format 14, Debian 12's, leaves it. Where it is not installed, that is said and
# nothing fails.
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"

if ! clang-format --version 2> /dev/null | grep -q 'version 14\.'; then
    echo 'format: skipped, clang-format 14 is not installed'
    exit 0
fi
mapfile -t sources < <(find core scripting tests -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.cu' -o -name '*.cuh' \) | LC_ALL=C sort)
ill=0
for file in "${sources[@]}"; do
    clang-format "$file" | cmp -s - "$file" || { echo "$file:1: not formatted; run make format"; ill=$((ill + 1)); }
done
if ((ill)); then
    echo "format: $ill of ${#sources[@]} files differ"
    exit 1
fi
echo "format: ${#sources[@]} files are formatted"
