#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Object files built for instructions that not every processor has may define nothing that the linker could also take
# for the rest of the program: one function with a name of its own each, no weak symbol.
#
#   shared_code.sh OBJECT…
set -euo pipefail
(($#)) || { echo 'shared_code: no object file' >&2; exit 2; }
failed=0
for object in "$@"; do
    shared=$(nm -C --defined-only "$object" | grep -E '^[0-9a-f]* *[A-Zuvw] ' | grep -v ' T planula::[a-z]*::[a-z0-9]*_kernel()$' || true)
    [[ -z $shared ]] || { printf 'shared_code: %s\n%s\n' "$object" "$shared"; failed=1; }
done
exit "$failed"
