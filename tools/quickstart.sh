#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# From a fresh Debian 12 machine to pictures: installs what is missing, builds, renders the default
# scene with several configs into out/. Safe to run again.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

step() { printf '\n== %s\n' "$1"; }

step "Packages (tools/scripts/packages.txt)"
tools/scripts/install_packages.sh

step "Building the crevice command in release mode, into build/release"
cmake --preset release
cmake --build --preset release --target crevice

step "Rendering the default scene, into out"
mkdir -p out
configs=(balanced high mobile)
for config in "${configs[@]}"; do
    build/release/tools/crevice render "$config" \
        --out "color=out/$config.png" --out "ao=out/${config}_ao.png"
done

step "Done"
echo "The pictures, lit and AO alone, are in $PWD/out:"
for config in "${configs[@]}"; do
    echo "  $config.png  ${config}_ao.png"
done
echo "Next: build/release/tools/crevice --help"
