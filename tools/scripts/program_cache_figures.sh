#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fills in the table of docs/reference/program_cache.md: how long a renderer takes to make with its programs compiled,
# kept by --program-cache, and kept by Mesa itself; medians of 15 runs in turn. Mesa's own cache begins empty each
# time: with it switched off Mesa gives no binaries. CREVICE may name a built command; otherwise the release preset is
# built.
#
#   tools/scripts/program_cache_figures.sh
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
page=docs/reference/program_cache.md
runs=15

source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# created MESA_CACHE CONFIG OPTIONS...: milliseconds of Renderer::create
created() {
    MESA_SHADER_CACHE_DIR=$1 "$CREVICE" render "$2" --scene spheres --size 64x36 --backend egl \
        --out ao="$work/ao.pfm" --json "${@:3}" | sed -n 's/.*"create_ms": \([0-9.]*\).*/\1/p'
}
median() { sort -n "$1" | sed -n "$(((runs + 1) / 2))p" | xargs printf '%.1f'; }

for config in learnopengl gtao mobile balanced high reference; do
    rm -f -- "$work"/*.ms
    for ((run = 0; run < runs; run++)); do
        rm -rf -- "$work"/{mesa,other,kept} && mkdir "$work"/{mesa,other}
        created "$work/mesa" "$config" --program-cache "$work/kept" >>"$work/compiled.ms"
        created "$work/other" "$config" --program-cache "$work/kept" >>"$work/kept.ms"
        created "$work/mesa" "$config" >>"$work/mesa.ms"
    done
    programs=$(ls "$work/kept" | wc -l)
    kib=$(cat "$work"/kept/* | wc -c | awk '{ printf "%.0f", $1 / 1024 }')
    echo "| \`$config\` | $programs | $kib |" \
        "$(median "$work/compiled.ms") | $(median "$work/kept.ms") | $(median "$work/mesa.ms") |"
done >"$work/rows"

awk -v rows="$work/rows" '
    /^\| `/ { next }
    { print }
    /^\|---/ { while ((getline row < rows) > 0) print row }' "$page" >"$work/page.md"
cp -- "$work/page.md" "$page"
