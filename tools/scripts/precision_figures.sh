#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fills in the table of docs/precision.md: for every shipped config how much its occlusion in the built-in room, at
# 256x144 and radius 0.8, changes where mediump is half floats. CREVICE may name a built command; otherwise the release
# preset is built. Takes a minute.
#
#   tools/scripts/precision_figures.sh
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
page=docs/precision.md

source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# draw CONFIG PRECISION
draw() {
    "$CREVICE" render "$1" --scene room --size 256x144 --set radius=0.8 --frames 2 --precision "$2" \
        --out ao="$work/$2.pfm" --out color="$work/$2.png" 2>"$work/log" || { cat "$work/log" >&2; exit 1; }
}
# figures FULL HALF: rmse, bias and greatest change of one picture
figures() {
    "$CREVICE" compare "$1" "$2" | awk '
        { v[$1] = $2 }
        END {
            bias = sprintf("%+.4f", v["bias"])
            printf " %.4f | %s | %.3f |", v["rmse"], bias + 0 ? bias : "0", v["max"]
        }'
}

for config in configs/*.json; do
    name=$(basename -- "$config" .json)
    draw "$name" full
    draw "$name" half
    echo "| \`$name\` |$(figures "$work/full.pfm" "$work/half.pfm")$(figures "$work/full.png" "$work/half.png")"
done >"$work/rows"

awk -v rows="$work/rows" '
    /^\| `/ { next }
    { print }
    /^\|---/ { while ((getline row < rows) > 0) print row }' "$page" >"$work/page.md"
cp -- "$work/page.md" "$page"
