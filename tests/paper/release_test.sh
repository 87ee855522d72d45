#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# paper/release.sh, in a repository that the test makes: the same commit gives the same bytes, the sums are right, and a
# checkout with changes, another version or no article is refused.
set -euo pipefail
source_folder=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export HOME=$folder GIT_CONFIG_NOSYSTEM=1
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b
mkdir "$folder/checkout"
cd "$folder/checkout"
fail() { echo "release_test: $1" >&2; exit 1; }
# The folder is relative, as in the Makefile.
release() { bash "$source_folder/paper/release.sh" "$folder/article" "../$1" > "$folder/said" 2>&1; }
refuses() { # WORDS: that the message must hold
    if release refused; then fail "was not refused: $1"; fi
    grep -qF -- "$1" "$folder/said" || fail "wrong message for '$1': $(cat "$folder/said")"
    [[ -z $(ls "$folder/refused"/*.tar.xz 2> /dev/null) ]] || fail "wrote an archive though it refused: $1"
}

echo article > "$folder/article"
refuses 'not a git checkout'
git init -q
mkdir data
echo 'project(planula VERSION 1.2.3 LANGUAGES CXX)' > CMakeLists.txt
echo 'version: 1.2.3' > CITATION.cff
echo '{"version": "1.2.3"}' > codemeta.json
echo 1,2 > 'data/a table.csv'
echo '#!/bin/sh' > run.sh
chmod +x run.sh
git add . && git commit -qm first

# The same bytes at another time, under another umask, with files that git ignores nearby.
release one || fail "$(cat "$folder/said")"
mkdir -p .git/info && echo build > .git/info/exclude && mkdir build && echo x > build/x
touch -d 2001-01-01 CMakeLists.txt
(umask 077; release two) || fail "$(cat "$folder/said")"
cmp "$folder/one/planula-1.2.3.tar.xz" "$folder/two/planula-1.2.3.tar.xz" || fail 'two archives of one commit differ'

# Whole, and as its sums say.
(cd "$folder/one" && sha256sum --quiet -c planula-1.2.3.tar.xz.sha256)
mkdir "$folder/unpacked" && tar -C "$folder/unpacked" -xf "$folder/one/planula-1.2.3.tar.xz"
cd "$folder/unpacked/planula-1.2.3"
sha256sum --quiet -c SHA256SUMS
diff <(find . -type f -not -name SHA256SUMS | sort) <(printf './%s\n' CITATION.cff CMakeLists.txt codemeta.json 'data/a table.csv' paper.pdf run.sh | sort)
[[ $(wc -l < SHA256SUMS) == 6 && -x run.sh ]] || fail 'a file lost its sum or its mode'
cd "$folder/checkout"

echo 2,3 >> 'data/a table.csv'
refuses 'not committed'
git checkout -q .
sed -i s/1.2.3/1.2.4/ CITATION.cff && git commit -qam other
refuses 'CITATION.cff is of another version'
git revert -n HEAD && git commit -qm back
rm "$folder/article"
refuses 'there is no article'
echo 'release_test: passed'
