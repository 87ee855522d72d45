# SPDX-License-Identifier: MIT
# For the lints to source. files: the files under version control and new ones that are not ignored, sorted; without
# git, all but build/. Recorded runs are left out: they are as planula wrote them.
files() {
    { git ls-files --cached --others --exclude-standard 2> /dev/null || find . -type f -not -path './build/*' -not -path './.git/*'; } |
        sed 's|^\./||' | sort | while IFS= read -r file; do
            if [[ -f $file && $file != data/runs/* ]]; then printf '%s\n' "$file"; fi
        done
}
