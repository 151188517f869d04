#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fills in the figures of README.md and docs/methods: in each table that ends in
# `| room | spheres | street | cost | with geometry |`, the row of a config gets its rmse in the three scenes and, as ratios
# to the cost of learnopengl in the room, its cost without and with the geometry that occlusion alone needs; so does the
# row of a level of quality, such as `quality=low`.
#
#   tools/scripts/method_figures.sh            measures every shipped config; half an hour, on a quiet machine
#   tools/scripts/method_figures.sh FOLDER...  takes what `crevice bench` left there at 480x270 and radius 1
#
# CREVICE may name a built command; otherwise the release preset is built.
set -euo pipefail
if [[ ${1:-} == -* ]]; then
    echo "usage: tools/scripts/method_figures.sh [FOLDER...]" >&2
    exit 2
fi
results=()
for folder in "$@"; do results+=("$(realpath -- "$folder")"); done
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
if ((${#results[@]} == 0)); then
    bench=(bench --scene room --scene spheres --scene street --size 480x270 --radius 1 --no-budget --out "$work")
    "$CREVICE" "${bench[@]}"
    for level in off low medium high ultra; do
        "$CREVICE" "${bench[@]}" --config quality --set "quality=$level"
    done
    results=("$work")
fi
"$CREVICE" report "${results[@]}" --out "$work/report.html" --no-pictures

for page in README.md docs/methods/*.md; do
    awk -F, -v page="$page" '
        function ratioText(ratio) { return sprintf(ratio < 10 ? "%.2f" : "%.0f", ratio) }
        FNR == 1 && NR != 1 { FS = "|" }
        FILENAME != page {  # the report: columns by their names
            if (FNR == 1) { for (i = 1; i <= NF; ++i) column[$i] = i; next }
            if ($column["width"] != 480 || $column["height"] != 270 || $column["radius"] != 1) next
            set = $column["overrides"]
            if (set !~ /^(quality=[a-z]+ )?radius=1$/) next
            sub(/ ?radius=1/, "", set)
            name = "`" (set == "" ? $1 : set) "`"
            rmse[name, $column["scene"]] = sprintf("%.3f", $column["rmse"])
            if ($column["scene"] != "room") next
            cost[name] = ratioText($column["ratio_learnopengl"])
            with_geometry[name] = ratioText($column["ratio_with_geometry"])
            next
        }
        { $0 = $0 }  # split again, at the bars
        !/^\|/ { table = 0 }
        /\| room \| spheres \| street \| cost \| with geometry \|$/ { table = 1 }
        { config = $2; gsub(" ", "", config) }
        table && (config in cost) && ((config, "spheres") in rmse) && ((config, "street") in rmse) {
            row = ""
            for (i = 2; i < NF - 5; ++i) row = row "|" $i
            $0 = row "| " rmse[config, "room"] " | " rmse[config, "spheres"] " | " rmse[config, "street"] " | " \
                cost[config] " | " with_geometry[config] " |"
        }
        { print }' "$work/report.csv" "$page" >"$work/page.md"
    cmp -s "$work/page.md" "$page" || { cp -- "$work/page.md" "$page"; echo "changed $page"; }
done
