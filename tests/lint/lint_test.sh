#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Shows that the lint can fail: plants one violation at a time in a small project of its own and demands that the lint
# names it, and that the same project without it passes.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
project=$(mktemp -d)
trap 'rm -rf "$project"' EXIT
failed=0 checked=0

# A project that keeps every rule, with words in comments and strings that would break them in code.
fresh() {
    rm -rf "${project:?}"/*
    mkdir -p "$project"/core/{base,genome,physics,development,record} "$project"/scripting "$project"/tests
    cp -r "$here" "$project/tests/lint"
    cat > "$project/core/CMakeLists.txt" <<'TXT'
# SPDX-License-Identifier: MIT
room(base)
room(parameters)
room(genome      DEPENDS base)
room(physics     DEPENDS base)
room(development DEPENDS base
                         genome)
room(record      DEPENDS physics)
TXT
    printf '# SPDX-License-Identifier: MIT\nroom(language DEPENDS base)\nroom(program DEPENDS language record)\n' > "$project/scripting/CMakeLists.txt"
    local file
    for file in base/{random,math,parallel,lanes,text}.h genome/genome.h physics/step.h record/write.h; do
        printf '// SPDX-License-Identifier: MIT\n#pragma once\n' > "$project/core/$file"
    done
    cat >> "$project/core/base/math.h" <<'TXT'
namespace planula::math {
double tanh(double x);
double exp(double x);
}
TXT
    cat > "$project/core/development/grow.cpp" <<'TXT'
// SPDX-License-Identifier: MIT
// std::sin(x) and std::shuffle in a comment, /* and <thread> */ too.
#include "base/math.h"
#include "genome/genome.h"
#include <vector>
/* std::exp(1) over
   std::pow(2, 3) two lines */
double grow(double x) { return planula::math::tanh(x) + planula::math::exp(x) + 1'000; }
const char *words = "std::sin(x) \" std::mt19937 //"; // log(x)
TXT
    mkdir -p "$project"/core/parameters "$project"/paper/{decisions,sections}
    printf '// SPDX-License-Identifier: MIT\nPARAMETER(double, gravity, 5, 0, 9, "1", "ours", "weight")\n' > "$project/core/parameters/parameters.inl"
    printf '# Land\n\n`gravity` 5, `direction` down\n' > "$project/paper/decisions/0001-land.md"
    printf '%% SPDX-License-Identifier: MIT\n\\law{L1}{World} \\parameter{gravity}, \\choice{direction}: \\alternative{down}.\n' > "$project/paper/sections/rules.tex"
    printf '#include "base/random.h"\n' >> "$project/core/genome/genome.h"
    printf '#include "base/math.h"\n' >> "$project/core/physics/step.h"
    printf '#include <iostream>\n#include "physics/step.h"\n' >> "$project/core/record/write.h"
    mkdir "$project"/scripting/{language,program}
    printf '# SPDX-License-Identifier: MIT\nclean: ## removes\nSEEDS ?= 1\n' > "$project/Makefile"
    printf '%s\n' '# Read me' 'See `core/genome/genome.h`, [a page](paper/decisions/0001-land.md) (decision 0001), `gravity`, `make clean SEEDS=2`,' \
        '`planula run core/base/math.h --seeds 1`, `grow()` and `tests/core/<room>/*_test.cpp`.' '```sh' 'cp core/base/math.h core/base/mine.h   # not `core/none.h`' \
        'build/planula run core/base/mine.h' '```' '<!-- new: core/base/new.h -->' 'Make `core/base/new.h`.' > "$project/README.md"
    printf '%s\n' '# Changelog' '## New' '`core/old.h` is gone.' '## Old' '`core/older.h`' > "$project/CHANGELOG.md"
    mkdir -p "$project/tests/core/base"
    printf '// SPDX-License-Identifier: MIT\n// See genome/genome.h, base/math.h. Like file.lua (decision 0001).\n' > "$project/tests/core/base/math_test.cpp"
    printf '// SPDX-License-Identifier: MIT\n#include "base/text.h"\n' > "$project/scripting/language/state.h"
    printf '// SPDX-License-Identifier: MIT\n#include "language/state.h"\n#include "record/write.h"\nconst char *names[] = {"run", "--seeds"};\n' > "$project/scripting/program/run.cpp"
    LC_ALL=C awk -f "$project/tests/lint/rooms.awk" "$project"/{core,scripting}/CMakeLists.txt > "$project/paper/rooms.svg"
    printf '#include <thread>\n' >> "$project/core/base/parallel.h"
    printf '#include <immintrin.h>\n' >> "$project/core/base/lanes.h"
    printf '// SPDX-License-Identifier: MIT\n#include "record/write.h"\n' > "$project/scripting/program/main.cpp"
}

# passes LINT: the clean project passes.
passes() {
    checked=$((checked + 1))
    bash "$project/tests/lint/$1" "$project" > "$project/log" 2>&1 && return
    echo "lint_test: $1 rejects the clean project:"
    cat "$project/log"
    failed=$((failed + 1))
}

# catches LINT WORDS FILE LINE: with LINE appended to FILE the lint fails and says WORDS about that file.
catches() {
    fresh
    checked=$((checked + 1))
    mkdir -p "$(dirname "$project/$3")"
    [[ -e $project/$3 || $1 == sources.sh ]] || printf '// SPDX-License-Identifier: MIT\n' > "$project/$3"
    printf '%b\n' "$4" >> "$project/$3"
    if bash "$project/tests/lint/$1" "$project" > "$project/log" 2>&1; then
        echo "lint_test: $1 does not see in $3: $4"
    elif ! grep -F "$3:" "$project/log" | grep -qF -- "$2"; then
        echo "lint_test: $1 fails on $4, but does not say '$2' about $3:"
        cat "$project/log"
    else
        return 0
    fi
    failed=$((failed + 1))
}

fresh
passes layering.sh
passes sources.sh
passes documents.sh
passes rooms.sh

# Rooms.
catches layering.sh 'does not list physics' core/development/grow.cpp '#include "physics/step.h"'
catches layering.sh 'does not list development' core/physics/step.h '#include "development/grow.h"'
catches layering.sh 'does not list base' core/record/write.h '#include "base/math.h"'
catches layering.sh 'does not list genome' scripting/language/state.h '#include "genome/genome.h"'
catches layering.sh 'does not list program' scripting/language/state.h '#include "program/run.cpp"'
catches layering.sh 'room statistics: lists base, but includes nothing of it' core/CMakeLists.txt 'room(statistics DEPENDS base)'
catches layering.sh 'room tools: no room geometry stands above it' core/CMakeLists.txt 'room(tools DEPENDS geometry)\nroom(geometry)'
catches layering.sh 'room view: lists record, but includes nothing of it' scripting/CMakeLists.txt 'room(view DEPENDS record)'
catches layering.sh 'names no room' core/physics/step.h '#include "phisics/step.h"'
catches layering.sh 'does not exist' core/physics/step.h '#include "base/vector.h"'
catches layering.sh 'does not exist' scripting/program/main.cpp '#include "physics/missing.h"'
catches layering.sh 'without a room line' core/attic/old.cpp 'int x;'
catches layering.sh 'without a room line' scripting/old.cpp 'int x;'
catches layering.sh 'without a room line' scripting/physics/old.cpp 'int x;'
catches layering.sh 'draws random numbers' core/physics/step.h '#include "base/random.h"'

# Headers with one home.
for header in fstream iostream cstdio; do
    catches layering.sh 'outside storage, record, language and program' core/physics/step.h "#include <$header>"
done
catches layering.sh 'outside base/parallel' core/record/write.h '#include <thread>'
catches layering.sh 'outside base/parallel' scripting/program/main.cpp '  #  include <future>'
catches layering.sh 'outside base/lanes' core/physics/kernel.cpp '#include <immintrin.h>'
catches layering.sh 'outside base/lanes' core/physics/kernel.cpp '#include <arm_neon.h>'
catches layering.sh 'the streams of base/random.h' core/genome/genome.h '#include <random>'
catches layering.sh 'knows a clock' core/record/write.h '#include <chrono>'

# Constructs.
for call in 'std::sin(x)' 'std::exp (x)' 'std::pow(x, 2)' 'std::tanh(x)' 'std::log(x)' 'std::hypot(x, x)' '::cos(x)' 'sinf(x)' 'atan2(x, x)'; do
    catches layering.sh 'transcendental of libm' core/physics/step.h "inline double f(double x) { return $call; }"
done
catches layering.sh 'transcendental of libm' core/base/math.h 'inline double f(double x) { return std::exp(x); }'
catches layering.sh 'transcendental of libm' scripting/program/main.cpp 'double f(double x) { return /* own */ std::exp(x); }'
catches layering.sh 'a Stream of base/random.h' core/genome/genome.h 'std::normal_distribution<double> d;'
catches layering.sh 'a Stream of base/random.h' core/genome/genome.h 'void f(int *a) { std::shuffle(a, a + 3, g); }'
catches layering.sh 'a Stream of base/random.h' scripting/program/main.cpp 'int f() { return rand(); }'
catches layering.sh 'a hash that differs' core/genome/genome.h 'double f(double *a) { return std::reduce(a, a + 3); }'
catches layering.sh 'a hash that differs' core/genome/genome.h 'std::hash<int> h;'
catches layering.sh 'a clock outside' core/record/write.h 'long f() { return std::time(nullptr); }'
catches layering.sh 'walks through all' core/genome/genome.h 'std::unordered_map<int, int> all;\nint f() { int n = 0; for (const auto &[k, v] : all) n += v; return n; }'
catches layering.sh 'walks through seen_' core/genome/genome.h 'std::unordered_set<int> seen_;\nint f() { return *seen_.begin(); }'
catches layering.sh 'environment or locale' core/record/write.h 'auto h = std::getenv("HOME");'
catches layering.sh 'follows the locale' core/record/write.h 'double f(const char *s) { return std::strtod(s, nullptr); }'
catches layering.sh 'outside language/gate.h' scripting/language/state.cpp 'void f() { try { g(); } catch (...) {} }'
catches layering.sh 'outside LuaState' scripting/program/main.cpp 'int f(lua_State *L) { return lua_pcall(L, 0, 0, 0); }'

# Texts.
catches sources.sh 'no SPDX' core/physics/bare.cpp 'int x;'
catches sources.sh 'no SPDX' paper/bare.gp 'plot x'
catches sources.sh 'path of some machine' core/physics/step.h '// see /ho''me/somebody/notes'
catches sources.sh 'path of some machine' README.md 'out = "/tm''p/result.csv"'
catches sources.sh 'carriage return' core/physics/step.h 'int x;\r'
catches sources.sh 'blank at the end' core/physics/step.h 'int x; '
catches sources.sh 'unfinished work' core/physics/step.h '// TO''DO later'
catches sources.sh 'no page of paper/decisions names' core/parameters/parameters.inl \
    '// SPDX-License-Identifier: MIT\nPARAMETER(double, ether, 1, 0, 2, "1", "ours", "unexplained")'
catches sources.sh 'no page of paper/decisions names' core/parameters/parameters.inl \
    '// SPDX-License-Identifier: MIT\nCHOICE(Ether, ether, still, "ours", "unexplained", still, moving)'

catches sources.sh 'no rule of the article uses' core/parameters/parameters.inl \
    '// SPDX-License-Identifier: MIT\nPARAMETER(double, ether, 1, 0, 2, "1", "MN", "in no rule")'
catches sources.sh 'no rule of the article describes' core/parameters/parameters.inl \
    '// SPDX-License-Identifier: MIT\nCHOICE(Direction, direction, down, "ours", "where to", down, up)'
catches sources.sh 'a rule that the article does not have' core/physics/step.h '// Gravity (ru''le L2).'
catches sources.sh 'a rule that the article does not have' core/physics/step.h '// Gravity (§2.5; ru''les L1 to L3).'
catches sources.sh 'a rule that the article does not have' paper/sections/more.tex '% SPDX-License-Identifier: MIT\nGravity (\\ru''l{L4}).'

# Documentation.
catches documents.sh 'core/genome/gone.h does not exist' README.md 'See `core/genome/gone.h`.'
catches documents.sh 'core/gone/ does not exist' README.md 'Files `core/gone/`.'
catches documents.sh 'tests/core/*_test.c does not exist' README.md 'Files `tests/core/*_test.c`.'
catches documents.sh 'paper/gone.md does not exist' README.md 'A [page](paper/gone.md).'
catches documents.sh 'gone.csv does not exist' README.md 'In `gone.csv`.'
catches documents.sh 'no target `make dance`' README.md 'Say `make clean dance`.'
catches documents.sh 'reads no variable PARTNERS' README.md 'Say `make clean PARTNERS=2`.'
catches documents.sh 'has no command dance' README.md '```sh\nbuild/planula dance a.lua\n```'
catches documents.sh 'has no option --partners' README.md 'Say `planula run core/base/math.h --partners 2`.'
catches documents.sh 'nothing is called ether' paper/decisions/0001-land.md 'And `ether` 1.'
catches documents.sh 'decision 0002 does not exist' paper/decisions/0001-land.md 'See page 0002.'
catches documents.sh 'decision 0003 does not exist' core/physics/step.h '// See decision 0003.'
catches documents.sh 'names genome/gone.h' core/physics/step.h 'int x; // as in genome/gone.h.'
catches documents.sh 'names gone.lua' scripting/language/state.h '// What gone.lua says.'
catches rooms.sh 'make architecture' core/CMakeLists.txt '# More.\nroom(more DEPENDS base)'

if ((failed)); then
    echo "lint_test: $failed of $checked plants slip through"
    exit 1
fi
echo "lint_test: the lint passes and fails as it should in $checked cases"
