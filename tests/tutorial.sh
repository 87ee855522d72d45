#!/bin/bash
# SPDX-License-Identifier: MIT
# tutorial.sh PLANULA SOURCES: runs every block of TUTORIAL.md as it is written, in a folder of its own where
# build/planula is the program. Building it, which the first block does, is left out.
set -euo pipefail
program=$(realpath "$1") sources=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/build"
ln -s "$program" "$folder/build/planula"
awk '/^```sh$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$sources/TUTORIAL.md" | grep -v '^make program$' > "$folder/blocks.sh"
cd "$folder"
bash -euo pipefail blocks.sh > said.txt 2>&1 || { cat said.txt; exit 1; }

# What the text says about the results.
grep -q 'p [=<]' said.txt || { cat said.txt; echo "tutorial: no p value was printed"; exit 1; }
[[ -s build/tutorial/compared/best_fitness.svg && -s build/tutorial/network.svg ]] || { cat said.txt; echo "tutorial: a picture is missing"; exit 1; }
echo "tutorial: every block does what the text says"
