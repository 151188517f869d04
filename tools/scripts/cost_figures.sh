#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the presets cost on phones' GPUs, against what was approved. CREVICE may name a built command; otherwise the
# release preset is built. Half a minute; tools/scripts/mobile_compilers.sh builds the compilers first, once.
#
#   tools/scripts/cost_figures.sh          measures, and writes docs/cost/phones.json and the table of docs/cost.md
#   tools/scripts/cost_figures.sh --check  1 where a preset spills, loses occupancy or takes a tenth more; 77, and one
#                                          line, where the compilers are not there
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
page=docs/cost.md approved=docs/cost/phones.json
configs=(mobile_low mobile mobile_temporal balanced balanced_temporal high gtao gtao_half learnopengl)

case ${1:-} in
    "" | --check) ;;
    *) echo "usage: tools/scripts/cost_figures.sh [--check]" >&2; exit 2 ;;
esac
compilers=${CREVICE_MOBILE_COMPILERS:-${XDG_CACHE_HOME:-$HOME/.cache}/crevice/mobile_compilers}
if [[ ${1:-} == --check && ! -e $compilers/compile_programs ]]; then
    echo "SKIPPED: costs on phones: no compilers in $compilers; tools/scripts/mobile_compilers.sh builds them"
    exit 77
fi
source tools/scripts/built_crevice.sh

if [[ ${1:-} == --check ]]; then
    "$CREVICE" cost --check "$approved" || {
        echo "If that is meant: tools/scripts/cost_figures.sh, and say why in the commit."
        exit 1
    }
    exit 0
fi

mkdir -p docs/cost
"$CREVICE" cost "${configs[@]}" --out "$approved" >/dev/null

# A row for each config, from the sums; the file has each object without lists in one line.
awk '
    function value(key) {
        if (!match($0, "\"" key "\": ?[^,}]*")) return 0
        return substr($0, RSTART + length(key) + 3, RLENGTH - length(key) - 3) + 0
    }
    function finish() {
        if (config != "") print "| `" config "` | " fetches " | " tiles " | " with " | " g57 " |" cells " " half " |"
    }
    /"config":/ { finish(); config = $2; gsub(/[",]/, "", config); cells = "" }
    /"ao": \{/ { sum = "ao" }
    /"ao_with_geometry": \{/ { sum = "with" }
    /"passes": \[/ { sum = "" }
    sum == "ao" && /"fetches"/ { fetches = sprintf("%.1f", value("fetches")) }
    sum == "ao" && /"tile_bytes"/ { tiles = sprintf("%.1f", value("tile_bytes") / 1048576) }
    sum == "with" && /"tile_bytes"/ { with = sprintf("%.1f", value("tile_bytes") / 1048576) }
    sum == "ao" && /"largest_spills"/ {
        cells = cells sprintf(" %d:%d, %d/%d |", value("largest_spills"), value("its_fills"), \
            value("lowest_threads"), value("most_threads"))
        if (/Mali-G57/) g57 = sprintf("%d | %.1f", value("instructions"), value("cycles"))
        if (/Adreno/) half = sprintf("%.0f %%", 100 * value("arithmetic_16_bit") / value("arithmetic"))
    }
    END { finish() }' "$approved" >"$approved.rows"
awk -v rows="$approved.rows" '
    /^\| `/ { next }
    { print }
    /^\| config \|/ { table = 1 }
    /^\|---/ && table { while ((getline row < rows) > 0) print row }' "$page" >"$approved.page"
cp -- "$approved.page" "$page"
rm -f -- "$approved.rows" "$approved.page"
echo "wrote $approved and the table of $page"
