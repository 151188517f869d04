#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Measures the figures of the documentation and writes them into its tables: those below a line `<!-- figures: NAME -->`
# in README.md and docs. A cell is filled by the beginning of its row and by the heading of its column.
#
#   tools/scripts/figures.sh methods [FOLDER...]  error and cost of each config: half an hour on a quiet machine, or
#                                                 what `crevice bench` left there at 480x270 and radius 1
#   tools/scripts/figures.sh unseen               error on twenty scenes that presets are not tuned on: five minutes
#   tools/scripts/figures.sh stress [FOLDER]      where AO breaks: ten minutes; FOLDER keeps what is drawn
#   tools/scripts/figures.sh authors              the variant `sound` and other seeds of ports: two minutes
#   tools/scripts/figures.sh precision            half floats against 32 bits: a minute
#   tools/scripts/figures.sh cost                 costs on phones' GPUs, and docs/cost/phones.json: two minutes; also of
#                                                 peers, and docs/cost/peers.json, where tools/scripts/peers.sh made them
#   tools/scripts/figures.sh cost --check         changes nothing. Exit code 1 where a config spills, loses occupancy or
#                                                 costs a tenth more than in phones.json; 77 without the compilers,
#                                                 which tools/scripts/mobile_compilers.sh builds
#
# CREVICE may name a built command; otherwise the release preset is built.
set -euo pipefail
case "$*" in
    methods | unseen | stress | authors | precision | cost | "cost --check") ;;
    "methods "[!-]* | "stress "[!-]*) ;;
    *) sed -n 's/^#   //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac
name=$1 arguments=()
for argument in "${@:2}"; do
    [[ $argument == --check ]] || argument=$(realpath -m -- "$argument")
    arguments+=("$argument")
done
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

# --- tables ---

# configs_of NAME: the configs that have a row in the tables of that name.
configs_of() {
    awk -F'`' -v name="[ ,]$1[ ,]" '
        /^<!-- figures:/ { armed = $0 ~ name }
        /^\|/ { if (armed) inside = 1 }
        !/^\|/ { if (inside) armed = inside = 0 }
        inside && /^\| `[a-z0-9_]+` \|/ && !($2 in seen) { seen[$2]; print $2 }' "${pages[@]}"
}
# cell ROW COLUMN VALUE: a figure for `fill`.
cell() { printf '%s\t%s\t%s\n' "$@"; }
# fill NAME: writes cells, or whole rows, which begin with a bar, into the tables of that name.
fill() {
    local page marked
    cat >"$work/cells"
    : >"$work/used"
    [[ ! -e $work/failed ]] || exit 1
    [[ -s $work/cells ]] || { echo "nothing was measured for '$1'" >&2; exit 1; }
    marked=$(grep -lE "^<!-- figures:.*[ ,]$1[ ,]" "${pages[@]}") || { echo "no page has a table of '$1'" >&2; exit 1; }
    for page in $marked; do
        awk -v name="[ ,]$1[ ,]" -v cells="$work/cells" -v used="$work/used" '
            BEGIN {
                FS = "\t"
                while ((getline <cells) > 0) {
                    if (/^\|/) rows = rows $0 "\n"
                    else { value[$1, $2] = $3; begins[$1] }
                }
                FS = " *[|] *"; OFS = " | "
            }
            /^<!-- figures:/ { armed = $0 ~ name }
            !/^\|/ { if (columns) armed = columns = 0 }
            !armed || !/^\|/ { print; next }
            !columns { columns = NF; for (i = 3; i < NF; ++i) head[i] = $i; print; next }
            /^\|[-: |]*$/ { print; printf "%s", rows; next }
            rows != "" { next }
            {
                filled = 0
                for (row in begins) if (index($2, row) == 1) {
                    for (i = 3; i < NF; ++i) if ((row, head[i]) in value) { $i = value[row, head[i]]; filled = 1 }
                    print row >>used
                }
                if (filled) { sub(/^ /, ""); sub(/ $/, "") }
                print
            }' "$page" >"$work/page.md"
        cmp -s "$work/page.md" "$page" || { cp -- "$work/page.md" "$page"; echo "changed $page"; }
    done
    sed '/^|/d; s/\t.*//' "$work/cells" | sort -u | comm -23 - <(sort -u "$work/used") >"$work/left"
    [[ ! -s $work/left ]] || { sed 's/^/no table has the row: /' "$work/left" >&2; exit 1; }
}

# --- what is measured ---

methods() {
    local level bench=(bench --scene room --scene spheres --scene street --size 480x270 --radius 1)
    if (($# == 0)); then
        set -- "$work/bench"
        "$CREVICE" "${bench[@]}" --out "$1"
        for level in low high ultra; do "$CREVICE" "${bench[@]}" --out "$1" --config quality --set "quality=$level"; done
    fi
    "$CREVICE" report "$@" --out "$work/report.html" --no-pictures
    awk -F, -v OFS='\t' '
        function ratio(r) { return sprintf(r < 10 ? "%.2f" : "%.0f", r) }
        NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        $column["width"] == 480 && $column["height"] == 270 && $column["overrides"] ~ /^(quality=[a-z]+ )?radius=1$/ {
            set = $column["overrides"]
            sub(/ ?radius=1/, "", set)
            if (set ~ /=(off|medium)/) next
            row = "`" (set == "" ? $1 : set) "`"
            print row, $column["scene"], sprintf("%.3f", $column["rmse"])
            if ($column["scene"] != "room") next
            print row, "cost", ratio($column["ratio_learnopengl"])
            print row, "with geometry", ratio($column["ratio_with_geometry"])
        }' "$work/report.csv" | fill methods
}

unseen() {
    local seed scene radius
    mapfile -t configs < <(configs_of unseen | grep -vx reference)
    for seed in {500..519}; do
        read -r _ scene _ radius < <(python3 tests/unseen/scenes.py "$seed" "$work")
        quietly "$CREVICE" bench --scene "$scene" --radius "$radius" --size 480x270 --repeats 1 \
            "${configs[@]/#/--config=}" --out "$work/unseen"
    done
    quietly "$CREVICE" report "$work/unseen" --out "$work/report.html" --no-pictures
    awk -F, -v OFS='\t' '
        NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        { sum[$1] += $column["rmse"]; ++count[$1] }
        END { for (config in sum) print "`" config "`", "unseen", sprintf("%.3f", sum[config] / count[config]) }
        ' "$work/report.csv" | fill unseen
}

stress() {
    # What users meet most; other cases hold, or show the same from farther away.
    local got=0 table cases=(units offset near_far off_centre mirrored orientation wall_walk low_eye history cut still
        corner_radius samples inputs host_depth)
    configs_of authors >"$work/ports"
    configs_of methods | grep -vxF -f "$work/ports" -e reference >"$work/methods"  # `reference` takes as long as the rest
    # shellcheck disable=SC2046
    "$CREVICE" stress $(cat "$work/methods" "$work/ports") "${cases[@]/#/--case=}" --out "${1:-$work/stress}" \
        >"$work/report" || got=$?
    ((got == 0 || got == 5)) || exit "$got"
    # A row for each sentence, without how much is lost, and the configs of which it is true; the most configs first.
    for table in methods ports; do
        awk '
            NR == FNR { wanted[$0]; next }
            /^[^ ]/ { config = $0 }
            /^  AO of/ && config in wanted {
                sub(/^  AO of `[^`]*` /, "")
                sub(/: .*/, "")
                if (!($0 in count)) order[++n] = $0
                if ((config, $0) in seen) next
                seen[config, $0]
                configs[$0] = configs[$0] (count[$0]++ ? ", " : "") "`" config "`"
                if (count[$0] > most) most = count[$0]
            }
            END {
                for (; most; --most) for (i = 1; i <= n; ++i)
                    if (count[order[i]] == most) print "| " order[i] " | " configs[order[i]] " |"
            }' "$work/$table" "$work/report" | fill "stress_$table"
    done
}

draw() {  # FILE SCENE CONFIG [OPTION...]
    quietly "$CREVICE" render "$3" --scene "$2" --size 480x270 --set radius=1 --out "ao=$work/$1" "${@:4}"
}
difference() {  # FIGURE FILE FILE
    quietly "$CREVICE" compare "$work/$2" "$work/$3"
    awk -v figure="$1" '$1 == figure { printf "%.4f\n", $2 }' "$work/log"
}
ground_truth() {  # FILE SCENE [OPTION...]
    quietly "$CREVICE" reference --scene "$2" --size 480x270 --radius 1 --out "$work/$1" "${@:3}"
}
error() {  # SCENE CONFIG [OPTION...]: rmse against ground truth
    draw ao.pfm "$@"
    difference rmse ao.pfm "$1.pfm"
}

authors() {
    local config scene seed
    for scene in room spheres; do ground_truth "$scene.pfm" "$scene"; done
    for config in $(configs_of authors); do
        for scene in room spheres; do
            cell "\`$config\`" "\`sound\`: $scene" "$(printf %.3f "$(error "$scene" "$config" --variant sound)")"
        done
        cell "\`$config\`" "8 seeds: room" "$(for seed in {1..8}; do
            error room "$config" --set "/generated/kernel/seed=$seed"
        done | sort -g | awk '{ e[NR] = $1 } END { printf "%.3f, %.3f to %.3f", (e[4] + e[5]) / 2, e[1], e[8] }')"
    done | fill authors
}

precision() {
    local config kind figures=(render --scene room --size 256x144 --set radius=0.8 --frames 2)
    for config in $(configs_of precision); do
        for kind in full half; do
            quietly "$CREVICE" "${figures[@]}" "$config" --precision $kind --out ao="$work/$kind.pfm"
        done
        cell "\`$config\`" rmse "$(printf %.4f "$(difference rmse full.pfm half.pfm)")"
        cell "\`$config\`" bias "$(printf %+.4f "$(difference bias full.pfm half.pfm)")"
        cell "\`$config\`" most "$(printf %.3f "$(difference max full.pfm half.pfm)")"
    done | fill precision
}

of_peers='^(n8ao|three|postprocessing)_'  # what tools/scripts/peers.sh makes
cost() {
    local approved=docs/cost/phones.json
    if [[ ${1:-} == --check ]]; then
        "$CREVICE" cost --check "$approved" && return
        echo "If that is meant: tools/scripts/figures.sh cost, and say why in the commit."
        exit 1
    fi
    local all peers=${XDG_CACHE_HOME:-$HOME/.cache}/crevice/peers command compared=docs/cost/peers.json
    command=$(realpath -- "$CREVICE") all=$(configs_of cost)
    # shellcheck disable=SC2046
    "$CREVICE" cost $(grep -vE "$of_peers" <<<"$all") --out "$approved" >/dev/null
    if [[ -d $peers ]]; then  # the figures name no folder
        # shellcheck disable=SC2046
        (cd -- "$peers" && "$command" cost $(grep -E "$of_peers" <<<"$all" | sed 's/$/.json/') --out "$work/peers.json") \
            >/dev/null
        # Without the passes of each.
        awk '/^      "passes": \[/ { sub(/,$/, "", held); skip = 1 }
            !skip { if (held != "") print held; held = $0 }
            skip && /^      \]/ { skip = 0 }
            END { print held }' "$work/peers.json" >"$compared"
    fi
    # A row for each config, the cheapest first; the file has each object without lists in one line.
    local file
    for file in "$approved" "$compared"; do
        awk '
            function value(key) {
                if (!match($0, "\"" key "\": ?[^,}]*")) return 0
                return substr($0, RSTART + length(key) + 3, RLENGTH - length(key) - 3) + 0
            }
            function mebibytes() { return sprintf("%.1f", value("tile_bytes") / 1048576) }
            function end() {
                if (config != "") printf "%g\t| `%s` | %s | %s | %s | %.1f | about %s | %s | %s | %s |\n", cycles, config,
                    fetches, alone, with, cycles, ms, occupancy, spills, half
                most = -1
            }
            /"config":/ { end(); config = $2; gsub(/[",]|\.json/, "", config) }
            /"ao": \{/ { sum = "ao" }
            /"ao_with_geometry": \{/ { sum = "with" }
            /"passes": \[/ { sum = "" }
            sum == "ao" && /"fetches"/ { fetches = sprintf("%.1f", value("fetches")) }
            sum == "ao" && /"tile_bytes"/ { alone = mebibytes() }
            sum == "with" && /"tile_bytes"/ { with = mebibytes() }
            sum == "ao" && /"gpu":/ && value("largest_spills") + value("its_fills") > most {
                most = value("largest_spills") + value("its_fills")
                spills = value("largest_spills") ":" value("its_fills")
            }
            sum == "ao" && /"gpu": ?"Mali-G57"/ {
                cycles = value("megacycles")
                ms = sprintf(value("milliseconds") < 9.95 ? "%.1f" : "%.0f", value("milliseconds"))
                occupancy = value("lowest_threads") "/" value("most_threads")
            }
            sum == "ao" && /"gpu": ?"Adreno/ {
                half = sprintf("%.0f%%", 100 * value("arithmetic_16_bit") / value("arithmetic"))
            }
            END { end() }' "$file" | sort -g | cut -f 2
    done | fill cost
}

if [[ $* == "cost --check" ]]; then
    compilers=${CREVICE_MOBILE_COMPILERS:-${XDG_CACHE_HOME:-$HOME/.cache}/crevice/mobile_compilers}
    if [[ ! -e $compilers/compile_programs ]]; then
        echo "SKIPPED: costs on phones: no compilers in $compilers; tools/scripts/mobile_compilers.sh builds them"
        exit 77
    fi
fi
source tools/scripts/built_crevice.sh
pages=(README.md docs/*.md docs/*/*.md)
"$name" ${arguments[@]+"${arguments[@]}"}
