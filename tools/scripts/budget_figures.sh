#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Holds the error budget of `crevice bench` against edits of configs: writes the table of docs/bench.md, for each part by
# how much it says that the error changes and by how much it does, in four kinds of scene at 256x144. Exit code 1 where
# one is off by more than 10 % of the error. Takes three minutes. CREVICE may name a built command; otherwise the release
# preset is built.
#
#   tools/scripts/budget_figures.sh
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
page=docs/bench.md

source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# Quads of an OBJ file: a corner, two edges.
quads='function quad(x, y, z, ax, ay, az, bx, by, bz) {
    printf "v %g %g %g\nv %g %g %g\nv %g %g %g\nv %g %g %g\nf -4 -3 -2 -1\n", x, y, z, x + ax, y + ay, z + az,
        x + ax + bx, y + ay + by, z + az + bz, x + bx, y + by, z + bz
}'
grove() {  # nine trees of 700 leaves, which are open quads
    awk "$quads"'
        BEGIN {
            srand(7); quad(-20, 0, 20, 40, 0, 0, 0, 0, -40)
            for (t = 0; t < 9; ++t) {
                x = (t % 3 - 1) * 1.7 + rand() * 0.4; z = (int(t / 3) - 1) * 1.7 + rand() * 0.4
                quad(x - 0.06, 0, z, 0.12, 0, 0, 0, 1, 0); quad(x, 0, z + 0.06, 0, 0, -0.12, 0, 1, 0)
                for (i = 0; i < 700; ++i) {
                    do { a = 2 * rand() - 1; b = 2 * rand() - 1; c = 2 * rand() - 1 } while (a * a + b * b + c * c > 1)
                    u = rand() * 6.2832; v = rand() * 2 - 1; w = sqrt(1 - v * v); s = 0.16
                    quad(x + 0.7 * a, 1.4 + 0.7 * b, z + 0.7 * c, s * cos(u), 0, s * sin(u), -s * v * sin(u), s * w,
                        s * v * cos(u))
                }
            }
        }'
}
fence() {  # three rows of thin bars
    awk "$quads"'
        function box(x, y, z, w, h, d) {
            quad(x, y, z + d, w, 0, 0, 0, h, 0); quad(x + w, y, z, -w, 0, 0, 0, h, 0)
            quad(x + w, y, z + d, 0, 0, -d, 0, h, 0); quad(x, y, z, 0, 0, d, 0, h, 0)
            quad(x, y + h, z + d, w, 0, 0, 0, 0, -d)
        }
        BEGIN {
            quad(-4, 0, 4, 8, 0, 0, 0, 0, -8)
            for (z = 1.2; z > -1; --z) {
                for (i = 0; i < 26; ++i) box(0.2 * i - 2.6, 0, z, 0.06, 1.1, 0.05)
                box(-2.7, 0.25, z + 0.05, 5.3, 0.06, 0.03); box(-2.7, 0.85, z + 0.05, 5.3, 0.06, 0.03)
            }
        }'
}
grove >"$work/grove.obj"
fence >"$work/fence.obj"
for folder in "${CREVICE_MODELS:-}" /usr/{local/,}share/glmark2/models; do
    [[ -e $folder/bunny.obj && ! -e $work/bunny.obj ]] && cp -- "$folder/bunny.obj" "$work"
done
extends='"ssao/gtao", "filter/bilateral_normal", "lighting/blinn_phong"'
echo "{\"format\": 1, \"extends\": [\"geometry/position_normal\", $extends]}" >"$work/no_band.json"

declare -A file=([room]=room [grove]="$work/grove.obj" [fence]="$work/fence.obj" [bunny]="$work/bunny.obj")
declare -A radius=([room]=1 [grove]=0.5 [fence]=0.5 [bunny]=0.3)
declare -A camera=(
    [room]='eye=0.3,1.5,3.5;at=-0.1,0.72,-0.8;fov=50' [grove]='eye=2.2,1.6,3.2;at=0,0.8,0;fov=50'
    [fence]='eye=1.6,1.2,2.6;at=-0.3,0.4,0;fov=55' [bunny]='eye=-0.8,0.7,1.9;at=0,0.1,0;fov=45'
)

# bench SCENE NEAR OPTION CONFIG [SET...]: prints the file of results.
bench() {
    local scene=$1 near=$2 option=$3 config=$4 set=() each out
    shift 4
    for each in "$@"; do set+=(--set "$each"); done
    out=$work/$(printf '%s\n' "$scene" "$near" "$option" "$config" "$@" | md5sum | cut -d' ' -f1)
    [[ -e $work/$config.json ]] && config=$work/$config.json
    [[ -e $out ]] || "$CREVICE" bench --scene "${file[$scene]}" --size 256x144 --camera "${camera[$scene]}$near" \
        --radius "${radius[$scene]}" --repeats 1 --cache "$work/cache" --out "$out" --config "$config" \
        ${option:+"$option"} "${set[@]}" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
    echo "$out/results.jsonl"
}
figure() { sed -nE 's/.*"'"$1"'":(-?[0-9.e-]+).*/\1/p' "$2"; }

# row PART CONFIG... -- EDITED...: one line of the table; what only shows how far an edit gets is not judged.
row() {
    local part=$1 from=() cells='' scene budget real near=''
    shift
    while [[ $1 != -- ]]; do from+=("$1"); shift; done
    shift
    [[ $part == precision ]] && near=';near=0.0005'
    for scene in room grove fence bunny; do
        budget=$(bench "$scene" "$near" '' "${from[@]}")
        real=$(bench "$scene" "$near" --no-budget "$@")
        cells+=$(awk -v part="$part" -v error="$(figure rmse "$budget")" -v change="$(figure "${part%% *}" "$budget")" \
            -v real="$(figure rmse "$real")" -v offs="$work/off" 'BEGIN {
                if (part == "model") change -= error
                real -= error; off = (change - real) / error; if (off < 0) off = -off
                if (part !~ / /) print off, part >>offs
                printf " %.4f: %+.4f, %+.4f |", error, change, real
            }')
    done
    printf '| %s | `%s` | `%s` |%s\n' "$part" "${from[*]}" "$*" "$cells"
}

wide='["depth32f"]'
{
    row taps gtao -- gtao slices=16 steps=32
    row 'taps (8 times as many)' gtao -- gtao slices=8 steps=9
    row taps learnopengl -- learnopengl samples=128
    row filter gtao -- gtao filter/bilateral_normal=filter/none
    row filter learnopengl -- learnopengl filter/box=filter/none
    row filter balanced -- balanced depth_cut=0
    row half_size balanced -- balanced filter/upsample=filter/bilateral_normal
    row half_size mobile -- mobile filter/upsample=filter/bilateral_normal
    row off_screen gtao guard_band=1 -- gtao guard_band=2
    row off_screen no_band -- gtao guard_band=2
    row hidden_layers bitmask -- bitmask_layers slices=2 steps=4
    row hidden_layers balanced -- high slices=2 steps=4 guard_band=1.2
    row precision gtao '/targets/depth/format=["depth16"]' -- gtao "/targets/depth/format=$wide"
    row model gtao -- gtao slices=16 steps=32 filter/bilateral_normal=filter/none guard_band=2 \
        '/targets/ao/format=["r16f"]' "/targets/depth/format=$wide"
    row model balanced -- high slices=16 steps=32 filter/upsample=filter/none guard_band=2 '/targets/ao/format=["r16f"]'
} >"$work/rows"

awk -v rows="$work/rows" '
    /^\| [a-z_]+( \(.*\))? \| `.*: [-+]/ { next }
    { print }
    heading && /^\|---/ { while ((getline row < rows) > 0) print row }
    { heading = /^\| part \| config \| edit \|/ }' "$page" >"$work/page.md"
cp -- "$work/page.md" "$page"
sort -rg "$work/off" | awk '
    NR == 1 { printf "off by at most %.1f %% of the error (%s)\n", 100 * $1, $2; bad = $1 > 0.1 }
    END { exit bad }'
