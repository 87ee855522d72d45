#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the archive of a version: all tracked files as they were committed, the article, and SHA256SUMS of both. The same
# commit and the same article give the same bytes, whoever packs them, when and where.
#
#   release.sh ARTICLE FOLDER      writes FOLDER/planula-VERSION.tar.xz and its .sha256; run in the root of the checkout
#
# Refuses a checkout with changes that are not committed: what is archived must be what others can check out.
set -euo pipefail
article=$1 folder=$2
export LC_ALL=C TZ=UTC
fail() { echo "release: $1" >&2; exit 1; }

git rev-parse --is-inside-work-tree > /dev/null 2>&1 || fail 'this is not a git checkout; an archive is made from a commit'
[[ -z $(git status --porcelain) ]] || fail 'there are changes that are not committed: git status shows them'
[[ -s $article ]] || fail "there is no article at $article: make paper"
version=$(sed -nE 's/^project\(planula VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
[[ -n $version ]] || fail 'CMakeLists.txt states no version: project(planula VERSION …)'
for file in CITATION.cff codemeta.json; do
    grep -qF "$version" "$file" || fail "$file is of another version than CMakeLists.txt, $version"
done

name=planula-$version
mkdir -p "$folder"
work=$(mktemp -d "$(realpath "$folder")/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
git archive --prefix="$name/" HEAD | tar -C "$work" -xf -
cp "$article" "$work/$name/paper.pdf"
(cd "$work/$name" && find . -type f -not -name SHA256SUMS -printf '%P\0' | sort -z | xargs -0 sha256sum > "$work/sums" && mv "$work/sums" SHA256SUMS)

# Names in a fixed order; the time of the commit; no owner; one thread, as the number of threads changes what xz writes.
tar -C "$work" --sort=name --mtime="@$(git show -s --format=%ct HEAD)" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
    --format=ustar -cf - "$name" | xz --threads=1 -6 > "$work/archive"
mv "$work/archive" "$folder/$name.tar.xz"
(cd "$folder" && sha256sum "$name.tar.xz" > "$name.tar.xz.sha256")
echo "release: $folder/$name.tar.xz, $(wc -l < "$work/$name/SHA256SUMS") files, commit $(git rev-parse --short HEAD)"
