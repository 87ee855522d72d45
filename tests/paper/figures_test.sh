#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# paper/figures/plot.sh: the figures of experiments that the test runs. Each is drawn, names every search, and shows titles as
# they are written, whatever characters they have.
#
#   figures_test.sh PLANULA SOURCES CASE
set -euo pipefail
planula=$(realpath "$1") sources=$(realpath "$2") case=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$sources"
fail() { echo "figures_test: $1" >&2; [[ ! -f $folder/said ]] || cat "$folder/said" >&2; exit 1; }
run() { "$planula" run "$folder/$1.lua" --out "$folder/$1" --threads 1 > "$folder/said" 2>&1 || fail "could not run $1"; }
plot() { bash paper/figures/plot.sh "$planula" "$folder/$1" "$folder/out" "$2" > "$folder/said" 2>&1 || fail "could not draw $1"; }
drawn() { for name in "$@"; do [[ -s $folder/out/$name.svg ]] || fail "$name.svg is missing"
    ! grep -q 'scale(0\.00)' "$folder/out/$name.svg" || fail "$name.svg has a point of size 0, which librsvg refuses"; done; }
not_drawn() { for name in "$@"; do [[ ! -e $folder/out/$name.svg ]] || fail "$name.svg was drawn"; grep -q "^left out: $name: " "$folder/said" || fail "does not say why there is no $name"; done; }
# The words of a picture; gnuplot writes a text in one piece or in several.
words() { sed -E 's/<[^>]*>//g' "$folder/out/$1.svg" | tr -d '\n\t' | sed 's/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g'; }
shows() { words "$1" | grep -qF -- "$2" || fail "$1 does not show: $2"; }

case $case in
searches) # several searches in worlds of two kinds, each with what its search and its world have
    cat > "$folder/many.lua" <<'END'
local paper = require "paper"
local land = paper.terrestrial { obstacles = { { { 6, 0 }, { 8, 0 }, { 8, 2 }, { 6, 2 } } } }
local settings = {}
for _, search in ipairs { "neat", "novelty", "map-elites" } do
  settings[#settings + 1] = { name = search .. "-aq", search = search }
end
settings[#settings + 1] = { name = "novelty-te", search = "novelty", environment = land }
return paper.design { name = "many", parameters = { population = 20, generations = 3, seeds = 1 }, settings = settings }
END
    run many
    plot many svg
    drawn performance final cells size_entropy exploration walkers world archive map distribution heredity bodies
    for search in NEAT 'novelty search' MAP-Elites; do for name in performance final cells size_entropy distribution heredity; do shows $name "$search"; done; done
    shows performance 'best fitness (cell diameters)'
    shows performance 'oscillators, land'
    shows walkers 'novelty search'
    shows map MAP-Elites
    shows bodies MAP-Elites
    ;;
one) # one setting; a title of hostile characters; no unit where the fitness is not the paper's
    cat > "$folder/one.lua" <<'END'
local paper = require "paper"
return paper.experiment {
  name = "one",
  title = [[It's "50 %" {of} a_b^2 @x ~y $z \LaTeX & <é> #1 `ls`]],
  fitness = function(life, parameters, penalty) return life.cells * penalty end,
  parameters = { population = 8, generations = 2, seeds = 2 },
}
END
    run one
    plot one svg
    drawn performance final exploration distribution bodies
    not_drawn walkers world archive map
    shows performance "It's \"50 %\" {of} a_b^2 @x ~y \$z \\LaTeX & <é> #1 \`ls\`: oscillators, water, NEAT"
    ! words performance | grep -qF 'cell diameters' || fail 'gives the unit of another fitness'
    shows bodies "It's ”50 %” {of} a_b^2 @x ~y \$z \\LaTeX & <é> #1 \`ls\` (NEAT)"
    plot one 'pdf png'
    for file in "$folder"/out/*.pdf; do [[ $(head -c 5 "$file") == %PDF- ]] || fail "$file is no PDF"; done
    for file in "$folder"/out/*.png; do [[ $(head -c 4 "$file" | tail -c 3) == PNG ]] || fail "$file is no PNG"; done
    (($(find "$folder/out" -maxdepth 1 -name '*.pdf' | wc -l) == $(find "$folder/out" -maxdepth 1 -name '*.svg' | wc -l))) || fail 'PDF and SVG are not of the same figures'
    ;;
refused) # folders that have nothing to show
    refuses() { if bash paper/figures/plot.sh "$planula" "$1" "$folder/out" svg > "$folder/said" 2>&1; then fail "took $1"; fi; grep -qF -- "$2" "$folder/said" || fail "does not say: $2"; }
    refuses "$folder/nowhere" 'there is no folder'
    mkdir "$folder/empty"
    refuses "$folder/empty" 'has no complete run'
    mkdir -p "$folder/mixed"/{a,b}/seed-001/script
    for name in a b; do touch "$folder/mixed/$name/seed-001/manifest.csv"; echo "$name" > "$folder/mixed/$name/seed-001/script/experiment.lua"; done
    refuses "$folder/mixed" 'runs of different scripts'
    ;;
*) fail "there is no case $case" ;;
esac
echo 'figures_test: passed'
