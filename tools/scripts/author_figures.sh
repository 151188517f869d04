#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Prints the rows of the table "As written, and sound" of docs/methods/hemisphere.md: the rmse against ray-traced
# AO of each author's config, and of its variant sound. Half a minute, and a minute more where the references are not
# cached. CREVICE may name a built command; otherwise the release preset is built.
#
#   tools/scripts/author_figures.sh
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

rmse() {
    local config=$1 scene=$2
    shift 2
    "$CREVICE" render "$config" --scene "$scene" --size 480x270 --set radius=1 --out "ao=$work/ao.pfm" "$@" >"$work/log" 2>&1
    "$CREVICE" compare "$work/ao.pfm" "$work/$scene.pfm" | awk '$1 == "rmse" { printf "%.3f", $2 }'
}

for scene in room spheres; do
    "$CREVICE" reference --scene "$scene" --size 480x270 --radius 1 --out "$work/$scene.pfm" >"$work/log" 2>&1
done
for config in learnopengl chapman_depth lettier habr thesis ogldev45; do
    row="| \`$config\` |"
    for scene in room spheres; do
        row+=" $(rmse "$config" "$scene") | $(rmse "$config" "$scene" --variant sound) |"
    done
    echo "$row"
done
