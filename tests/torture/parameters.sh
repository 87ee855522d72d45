#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Does the signature depend on every parameter of the model? Changes one parameter after the other, in every setting of
# experiments/signature.lua, until the signature changes: by a tenth, by one, to twice and half its value, or to each
# name of a choice. Seeds and generations, which change no generation, and the parameters of statistics are left out.
#
#   parameters.sh PROGRAM [NAME…]      all parameters, unless some are named
#
# Prints how each parameter was seen or that it was not, and a last line that counts; fails if one was not seen.
set -euo pipefail
cd "$(dirname "$0")/../.."
program=$(realpath "$1")
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# changed NAME EXPRESSION: the signature with a parameter v changed to what the expression says.
changed() {
    local script=$folder/$1.lua
    cat > "$script" << END
local design, name = require "signature", "$1"
local settings = {}
for i, setting in ipairs(design.settings) do
  local own = setting.parameters or {}
  local v = own[name] or design.parameters[name] or planula.parameters[name]
  settings[i] = planula.change(setting, { parameters = { [name] = $2 } })
end
return planula.fill({ settings = settings }, design)
END
    "$program" signature --script "$script" --threads 1
}

# names_of NAME: the names of a choice, each on a line; nothing for a number.
names_of() {
    "$program" parameters | sed -nE "s/^  $1 = [a-z]+ \[([a-z |]+)\].*/\1/p" | tr -d ' ' | tr '|' '\n'
}

# seen NAME: prints how a parameter was changed when the signature changed.
seen() {
    local expression value refusals=0 changes
    mapfile -t changes < <(names_of "$1" | sed "s/.*/'&'/")
    ((${#changes[@]})) || changes=('1.1 * v' '0.9 * v' 'v + 1' 'v - 1' '2 * v' 'v / 2')
    for expression in "${changes[@]}"; do
        # Some changes are out of a parameter's range.
        value=$(changed "$1" "$expression" 2> "$folder/$1.said") || { refusals=$((refusals + 1)); continue; }
        [[ $value != "$unchanged" ]] || continue
        echo "parameters: $1 is seen at $expression"
        return
    done
    echo "parameters: $1 is NOT seen ($refusals of ${#changes[@]} changes refused)"
}

unchanged=$("$program" signature)
export program folder unchanged
export -f changed names_of seen
names=("$@")
(($#)) || mapfile -t names < <("$program" parameters --csv |
    awk -F, 'NR > 1 && $1 != "Statistics" && $2 != "seeds" && $2 != "generations" { print $2 }')
((${#names[@]})) || { echo "parameters: $program lists no parameter" >&2; exit 1; }
printf '%s\n' "${names[@]}" | xargs -P "${JOBS:-$(nproc)}" -I {} bash -c 'seen {}' > "$folder/table"
sort "$folder/table"
unseen=$(grep -c 'NOT seen' "$folder/table") || true
echo "parameters: $((${#names[@]} - unseen)) passed, $unseen failed"
((unseen == 0))
