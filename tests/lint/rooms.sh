#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Whether paper/rooms.svg shows the rooms of core/CMakeLists.txt and scripting/CMakeLists.txt; with --draw draws it.
#
#   rooms.sh [ROOT] [--draw]    ROOT is the checkout; by default the one this script lies in
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
[[ ${1:---draw} == --draw ]] || { root=$1 && shift; }
cd "$root"
picture=paper/rooms.svg
draw() { LC_ALL=C awk -f "$here/rooms.awk" core/CMakeLists.txt scripting/CMakeLists.txt; }
if [[ ${1-} == --draw ]]; then
    draw > "$picture"
elif ! draw | cmp -s - "$picture"; then
    echo "core/CMakeLists.txt:1: $picture does not show these rooms; run make architecture"
    exit 1
fi
echo "rooms: $picture shows $(grep -c 'class="name"' "$picture") rooms"
