# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# For the scripts of this folder, to be sourced at the root of the sources: CREVICE is the crevice command, built by
# the release preset where the caller named none.
if [[ -z ${CREVICE:-} ]]; then
    cmake --preset release && cmake --build --preset release --target crevice
    CREVICE=build/release/tools/crevice
fi
