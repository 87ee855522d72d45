#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Typesets the article: as often as its references need, with every cache inside OUT.
#
#   typeset.sh OUT DATA FIGURES      makes OUT/paper.pdf; run in the root of the checkout
set -euo pipefail
out=$1
work=$out/paper
mkdir -p "$work" "$out/texmf"
export TEXINPUTS=paper: LUAINPUTS=paper: TEXMFVAR=$out/texmf TEXMFCACHE=$out/texmf
main="\\def\\datafolder{$2}\\def\\figuresfolder{$3}\\input{paper.tex}"

# What a killed run has left of its references may be cut off in the middle.
[[ -f $work/whole ]] || rm -f "$work"/paper.{aux,toc,out}
rm -f "$work/whole"

for round in 1 2 3 4; do
    before=$(cat "$work"/paper.{aux,toc,out} 2> /dev/null | cksum || true)
    lualatex --interaction=nonstopmode --halt-on-error --file-line-error --output-directory="$work" --jobname=paper "$main" \
        < /dev/null > "$work/terminal" 2>&1 || { grep -A 6 -E '^(!|[^ ]+:[0-9]+:)' "$work/terminal" >&2 || tail -n 30 "$work/terminal" >&2; exit 1; }
    [[ $(cat "$work"/paper.{aux,toc,out} 2> /dev/null | cksum || true) != "$before" ]] || break
done

# An unresolved reference or a glyph that the font lacks is an error, not a blemish.
if grep -E 'undefined references|Reference .* undefined|Missing character' "$work/paper.log" >&2; then exit 1; fi
mv "$work/paper.pdf" "$out/paper.pdf"
touch "$work/whole"
