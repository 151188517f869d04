# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# For the scripts of this folder, to be sourced at the root of the sources: CREVICE is the crevice command, built by
# the release preset where the caller named none; what is in the folder `work` goes when the script ends.
if [[ -z ${CREVICE:-} ]]; then
    cmake --preset release && cmake --build --preset release --target crevice
    CREVICE=build/release/tools/crevice
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# quietly COMMAND...: shows what it prints only where it fails, and then ends.
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; touch "$work/failed"; exit 1; }; }
