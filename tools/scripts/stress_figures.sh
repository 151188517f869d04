#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes where each shipped config breaks into docs: a line a config under "Breakdown points" of the page that
# docs/methods/README.md names for it, and those of the presets and gtao, with figures, under "Where the presets break" of
# docs/stress.md.
#
#   tools/scripts/stress_figures.sh          runs the cases below, all steps, at 256x144: ten minutes on two cores
#   tools/scripts/stress_figures.sh FOLDER   takes what such a run left there, and draws what is missing
#
# CREVICE may name a built command; otherwise the release preset is built.
set -euo pipefail
if [[ ${1:-} == -* || $# -gt 1 ]]; then
    echo "usage: tools/scripts/stress_figures.sh [FOLDER]" >&2
    exit 2
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
out=$work
[[ $# == 0 ]] || out=$(realpath -- "$1")
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
source tools/scripts/built_crevice.sh

# What most users meet; other cases hold, or show the same from farther away.
cases=(units offset near_far off_centre mirrored narrow orientation wall_walk zoom low_eye history cut still tiles
    radius_growing corner_radius samples inputs host_projection host_encoding host_depth)
# "gtao gtao.md" for each row of the table of all configs, but for `reference`, which takes as long as all others.
awk -F '[`(|)#]' '/^\| `[a-z0-9_]+` \| \[[^]]*\]\([a-z_]+\.md/ && $3 != "reference" { print $3, $6 }' \
    docs/methods/README.md >"$work/pages"
mapfile -t configs < <(cut -d ' ' -f 1 "$work/pages")
got=0
"$CREVICE" stress "${configs[@]}" "${cases[@]/#/--case=}" --out "$out" >"$work/report" || got=$?
((got == 0 || got == 5)) || exit "$got"

# sentences CONFIG: each on a line.
sentences() {
    awk -v config="$1" '
        /^[^ ]/ { on = $0 == config }
        on && /^  (AO of|Nothing breaks)/ { print substr($0, 3) }' "$work/report"
}

# The config's line: what becomes of AO, and where, without figures of how much.
line_of() {
    sentences "$1" | awk -v config="$1" '
        /^AO of/ {
            sub(/^AO of `[^`]*` /, "")
            sub(/: .*/, "")
            if (!($0 in told)) line = line (line == "" ? "" : "; ") $0
            told[$0]
        }
        END { print "* AO of `" config "` " (line == "" ? "breaks nowhere." : line ".") }'
}

# replace PAGE HEADING: the lines of the section that begin with "* " become those of $work/lines.
replace() {
    awk -v lines="$work/lines" -v heading="## $2" '
        /^## / { on = $0 == heading }
        on && /^\* / { next }
        { print }
        on && /^    crevice stress/ { print ""; while ((getline line < lines) > 0) print line; getline }
    ' "$1" >"$work/page"
    cmp -s "$work/page" "$1" || { cp -- "$work/page" "$1"; echo "changed $1"; }
}

cut -d ' ' -f 2 "$work/pages" | sort -u | while read -r page; do
    while read -r config its_page; do
        [[ $its_page != "$page" ]] || line_of "$config"
    done <"$work/pages" >"$work/lines"
    grep -q '^## Breakdown points$' "docs/methods/$page" || cat >>"docs/methods/$page" <<'MARKDOWN'

## Breakdown points

What most users meet first, and what still holds ([how to read it](../stress.md#how-to-read-it)). With pictures, by

    crevice stress CONFIG

* to be written
MARKDOWN
    replace "docs/methods/$page" 'Breakdown points'
done
for config in gtao mobile balanced high; do
    sentences "$config" | sed -E 's/^/* /; s/ (Every|Many|Few|Only) [a-z ]+ meets? it: .*//'
done >"$work/lines"
replace docs/stress.md 'Where the presets break'
