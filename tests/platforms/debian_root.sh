#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Unpacks Debian packages of another processor, and all that they need, into a folder, for qemu-user's -L.
# Needs no root rights and changes nothing outside of the folder.
#   debian_root.sh FOLDER ARCHITECTURE PACKAGE...
set -euo pipefail
mkdir -p -- "$1"
root=$(cd -- "$1" && pwd)
architecture=$2
shift 2
[[ -e $root/complete ]] && exit 0

mkdir -p "$root/apt/lists/partial" "$root/apt/archives/partial"
: >"$root/apt/status"  # no package is there yet
apt_get() {
    apt-get -qq -o APT::Architecture="$architecture" -o APT::Architectures="$architecture" \
        -o APT::Sandbox::User="$(id -un)" -o Dir::State="$root/apt" -o Dir::State::status="$root/apt/status" \
        -o Dir::Cache="$root/apt" "$@" >/dev/null 2>>"$root/apt/log"
}
apt_get update || true  # a source of this machine that lacks the architecture
if ! apt_get install --yes --no-install-recommends --download-only "$@"; then
    tail -3 "$root/apt/log" >&2
    exit 1
fi
for package in "$root"/apt/archives/*.deb; do dpkg-deb --extract "$package" "$root"; done
rm -rf -- "$root/apt"
touch "$root/complete"
