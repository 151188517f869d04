#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the Debian packages of tools/scripts/packages.txt, and those named as arguments, where they are
# missing. Asks no question; where nothing is missing it needs neither network nor root.
set -euo pipefail

fail() { printf 'install_packages.sh: %s\n' "$1" >&2; exit 1; }

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
mapfile -t wanted < <(sed -e 's/#.*//' -e 's/ *>=.*//' -e '/^[[:space:]]*$/d' -- "$here/packages.txt")
wanted+=("$@")

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    fail "this is no Debian system (there is no apt-get); install the counterparts of these
packages by hand, then build as in README.md: ${wanted[*]}"
fi

missing=()
for package in "${wanted[@]}"; do
    status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
    echo "All ${#wanted[@]} packages are there."
    exit 0
fi

as_root=()
if ((EUID != 0)); then
    command -v sudo >/dev/null ||
        fail "need root or sudo to install: ${missing[*]}"
    as_root=(sudo)
fi
apt_get() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get --quiet --option DPkg::Lock::Timeout=300 "$@"
}

echo "Installing: ${missing[*]}"
apt_get update || echo "install_packages.sh: the package lists could not be renewed; going on" >&2
apt_get install --yes --no-install-recommends "${missing[@]}" ||
    fail "apt-get says above which of these cannot be installed: ${missing[*]}
Check /etc/apt/sources.list and the network; crevice is built on Debian 12."
