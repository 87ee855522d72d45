#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the named Debian packages that are missing, in one call of apt-get: as root, or through a sudo that asks
# nothing. Where neither works, prints the line to run and fails. Says nothing and takes no time when all are there.
set -euo pipefail

if ! command -v dpkg-query > /dev/null; then
    echo "deps: no Debian package system here; needed are, by their Debian names: $*" >&2
    exit 0
fi
installed=$(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "$@" 2> /dev/null || true)
missing=()
for package in "$@"; do
    grep -qxF "$package installed" <<< "$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

options=(-y --no-install-recommends -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3)
if [[ $(id -u) == 0 ]]; then
    as_root=(env DEBIAN_FRONTEND=noninteractive)
elif command -v sudo > /dev/null && sudo -n true 2> /dev/null; then
    as_root=(sudo -n env DEBIAN_FRONTEND=noninteractive)
else
    echo "deps: not root, and sudo would ask; please run:" >&2
    echo "  apt-get ${options[*]} install ${missing[*]}" >&2
    exit 1
fi

echo "deps: installing ${#missing[@]} packages and what they need: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
update() { "${as_root[@]}" apt-get -o Acquire::Retries=3 update > "$log" 2>&1 || { cat "$log" >&2; exit 1; }; }
install() { "${as_root[@]}" apt-get "${options[@]}" install "${missing[@]}" < /dev/null > "$log" 2>&1; }

# Without package lists nothing can be found; with old ones a file may be gone: then they are fetched once more.
compgen -G '/var/lib/apt/lists/*_Packages*' > /dev/null || update
install || { update; install; } || { cat "$log" >&2; exit 1; }
