#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Measures what authors claim of ambient occlusion and writes the tables of docs/claims.md. CREVICE may name a built
# command; otherwise the release preset is built.
#
#   tools/scripts/claims.sh            by errors; half a minute, and a minute more where the references are not cached
#   tools/scripts/claims.sh --times    by ratios of times, on a quiet machine; four minutes
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
case ${1:-} in
    "") table=error ;;
    --times) table='time' ;;
    *) echo "usage: tools/scripts/claims.sh [--times]" >&2; exit 2 ;;
esac
source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

crevice() { "$CREVICE" "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }; }
row() { printf '| %s | %s | %s | %s |\n' "$@"; }

# --- errors ---

draw() {  # FILE SCENE CONFIG [OPTION...]
    local file=$1 scene=$2 config=$3
    shift 3
    crevice render "$config" --scene "$scene" --size 480x270 --set radius=1 --out "ao=$work/$file" "$@"
}
difference() {  # FIGURE FILE FILE
    "$CREVICE" compare "$work/$2" "$work/$3" | awk -v figure="$1" '$1 == figure { printf "%.4f", $2 }'
}
error() {  # SCENE CONFIG [OPTION...]: rmse against ground truth
    draw ao.pfm "$@"
    difference rmse ao.pfm "$1.pfm"
}
below_open() {  # CONFIG [OPTION...]: how much darker than open a plane is
    draw ao.pfm plane "$@"
    difference bias ao.pfm plane.pfm | tr -d -
}
slats=(--camera 'eye=0.6,0.4,2.6;at=0,0,0')
slats() {  # GAP: a wall with slats of 2 cm in front of it, every 40 cm
    awk -v gap="$1" '
        function box(x0, x1, z0, z1,  i, c) {
            for (i = 0; i < 8; ++i) print "v", (i % 2 ? x1 : x0), (int(i / 2) % 2 ? 2 : -2), (i > 3 ? z1 : z0)
            split("1 3 4 2,5 6 8 7,1 2 6 5,3 7 8 4,1 5 7 3,2 4 8 6", faces, ",")
            for (i = 1; i <= 6; ++i) { split(faces[i], c, " "); print "f", c[1] + k, c[2] + k, c[3] + k, c[4] + k }
            k += 8
        }
        BEGIN {
            box(-3, 3, -0.2, 0)
            for (i = -7; i <= 7; ++i) box(0.4 * i - 0.01, 0.4 * i + 0.01, gap, gap + 0.02)
        }'
}
behind_slats() {  # CONFIG [OPTION...]: by how much the mean AO is off with slats 0.3 and 0.6 before the wall
    local gap
    for gap in 3 6; do
        draw ao.pfm "$work/slats$gap.obj" "$@" "${slats[@]}"
        printf ' %s' "$(difference bias ao.pfm "slats$gap.pfm")"
    done
}
level() { error room quality --set "quality=$1"; }
tile() { error room hemisphere_box --set samples=8 --set "$noise=$1" --set "blur_size=$1"; }
noisy() {  # SETTING...: rmse against ground truth, and that against many rotated samples
    printf '%s (%s)' "$(error room hemisphere_box "${@/#/--set=}")" "$(difference rmse ao.pfm many.pfm)"
}
unrotated() { noisy "samples=$1" "$noise=1" blur_size=1; }

error_rows() {
    local kernel=/generated/kernel noise=/generated/rotation_noise/count scene gap
    for scene in room spheres plane; do
        crevice reference --scene "$scene" --size 480x270 --radius 1 --out "$work/$scene.pfm"
    done
    for gap in 3 6; do
        slats "0.$gap" >"$work/slats$gap.obj"
        crevice reference --scene "$work/slats$gap.obj" "${slats[@]}" --size 480x270 --radius 1 --out "$work/slats$gap.pfm"
    done
    draw many.pfm room hemisphere_box --set samples=250 --set blur_size=1
    draw one.pfm room thesis --set filter/bilateral=filter/bilateral_2d
    draw two.pfm room thesis
    row '64 samples are more than are needed' 'LearnOpenGL' \
        "\`learnopengl\`, room: 64 $(error room learnopengl), 32 $(error room learnopengl --set samples=32), 16 $(error room learnopengl --set samples=16)" \
        'yes: the error is the method'"'"'s, not the noise'"'"'s'
    row 'Offsets near the point look better (quadratic lengths)' 'Chapman; LearnOpenGL' \
        "\`hemisphere_box\`, room: even $(error room hemisphere_box), linear $(error room hemisphere_box --set $kernel/lengths=linear), quadratic $(error room hemisphere_box --set $kernel/lengths=quadratic)" \
        'no: they miss the occlusion away from creases'
    row 'A hemisphere makes twice the samples useful' 'Chapman; Filion, McNaughton' \
        "spheres: \`sphere_box\` with 32 $(error spheres sphere_box), \`hemisphere_box\` with 16 $(error spheres hemisphere_box --set samples=16)" \
        'yes, and more: a sphere is wrong on every wall'
    row 'A sphere kernel greys flat walls' 'Mittring; OGLdev' \
        "a plane is darker by: \`ogldev45\` $(below_open ogldev45), \`sphere_box\` $(below_open sphere_box), \`hemisphere_box\` $(below_open hemisphere_box)" \
        'yes'
    row 'Two passes of a bilateral filter look like one' 'thesis' \
        "\`thesis\` against \`bilateral_2d\`, room: $(difference rmse one.pfm two.pfm), with 10 fetches of AO instead of 25" 'yes'
    row 'Tiles of noise beyond 8x8 do not pay' 'Habr' \
        "\`hemisphere_box\`, 8 samples, a box of the tile's size, room: 2x2 $(tile 2), 4x4 $(tile 4), 8x8 $(tile 8), 16x16 $(tile 16)" \
        'yes, nor beyond 4x4: the wider filter blurs away what more directions gain'
    row 'Without rotation about 200 samples are needed, with it and a filter 16' 'Wikipedia, "Screen space ambient occlusion"' \
        "\`hemisphere_box\`, room, and from its own picture of 250 rotated samples unfiltered: 16 rotated and filtered $(noisy samples=16); unrotated, unfiltered 64 $(unrotated 64), 128 $(unrotated 128), 250 $(unrotated 250)" \
        'no, for offsets that fill the ball evenly: 64 are as good as the 16; of random ones it took 128 to 250'
    row 'Without a range check there are halos' 'Chapman; LearnOpenGL' \
        "\`learnopengl\`, spheres: with $(error spheres learnopengl), without $(error spheres learnopengl --variant no_range_check)" \
        'yes'
    row 'Without a bias surfaces occlude themselves' 'Habr; LearnOpenGL' \
        "a plane is darker by: \`habr\` $(below_open habr), \`without_bias\` $(below_open habr --variant without_bias)" 'yes'
    row 'A power of the occlusion, as the text has it, does what the code does' 'Chapman' \
        "\`chapman_depth\`, room: visibility $(error room chapman_depth), occlusion $(error room chapman_depth --variant as_written)" \
        'no: one darkens, the other lightens'
    row 'What is off the screen cannot occlude' 'SCS; all' \
        "\`gtao\`, room: without a guard band $(error room gtao --set guard_band=1), with one of 1.4 views $(error room gtao)" \
        'yes; a guard band mends it, and the geometry pass then draws twice the pixels'
    row 'A filter that knows depth is better than a box' 'thesis; Habr' \
        "\`gtao\`, room: $(error room gtao), with \`box\` $(error room gtao --set filter/bilateral_normal=filter/box)" \
        'yes, by little: silhouettes are few pixels'
    row 'Horizons are closer to the truth than counted offsets' 'Bavoil; Jimenez' \
        "room: \`hbao\` $(error room hbao), \`gtao\` $(error room gtao), \`hemisphere_box\` $(error room hemisphere_box)" \
        'of `gtao` yes; of `hbao` no'
    row 'Thin things occlude too much' 'SCS; HBAO' \
        "slats of 0.02, 0.3 and 0.6 before a wall, mean error (below 0 is too dark): no AO$(behind_slats gtao --set intensity=0), \`hbao\`$(behind_slats hbao), \`gtao\`$(behind_slats gtao), \`bitmask\`$(behind_slats bitmask), \`bitmask_back\`$(behind_slats bitmask_back)" \
        'of `hbao` and `bitmask` yes, of `gtao` across the wider gap; with back faces they occlude too little'
    row 'Levels of quality trade error for time' 'SCS' \
        "\`quality\`, room: off $(level off), low $(level low), medium $(level medium), high $(level high), ultra $(level ultra); [presets](methods/presets.md) has the times" \
        'yes: half of what `high` leaves costs five times as much'
}

# --- times ---

rounds=5
frame='hemisphere_bilateral --set reflection=blinn_phong'
forward='--set lighting/blinn_phong=lighting/forward --set geometry/depth_normal=geometry/depth_only'
one_pass='--set filter/bilateral=filter/bilateral_2d'
waves() {  # CELLS: a wavy floor of 2 x CELLS x CELLS triangles, larger than the view
    awk -v n="$1" -v pi=3.14159265 'BEGIN {
        for (j = 0; j <= n; ++j) for (i = 0; i <= n; ++i) {
            x = 4 * i / n - 2; z = 4 * j / n - 2
            print "v", x, 0.2 * cos(pi * x) * cos(pi * z), z
        }
        for (j = 0; j < n; ++j) for (i = 1; i <= n; ++i) {
            a = j * (n + 1) + i; b = a + n + 1
            print "f", a, b, b + 1; print "f", a, b + 1, a + 1
        }
    }'
}
measure() {  # CONFIG, with what it sets; OPTION...: no error is asked for, so few rays do
    # shellcheck disable=SC2086  # words of the config are options
    crevice bench --radius 1 --rays 4 --no-budget --repeats 3 --cache "$work/cache" --out "$work/$round" --config $1 "${@:2}"
}
measure_times() {  # everything once a round, so that a slow minute falls on all of it
    local round config floor=(--scene "$work/few.obj" --scene "$work/many.obj" --camera 'eye=0,1.8,0.3;at=0,0,0')
    waves 24 >"$work/few.obj"
    waves 500 >"$work/many.obj"
    for ((round = 1; round <= rounds; ++round)); do
        measure gtao "${floor[@]}" --size 480x270
        measure gtao --scene room --scene spheres --size 480x270
        measure gtao --scene room --size 960x540
        for config in "$frame" "$frame $forward"; do
            measure "$config" "${floor[@]}" --size 480x270 --output color
            measure "$config" --scene room --size 480x270 --output color
        done
        measure thesis --scene room --size 960x540
        measure "thesis $one_pass" --scene room --size 960x540
        crevice report "$work/$round" --out "$work/$round.html" --no-pictures
    done
}
rounds_of() {  # UNIT PASSES SCENE WIDTH CONFIG: the passes with such names, a line a round
    awk -F, -v unit="$1" -v passes="$2" -v scene="$3" -v width="$4" -v family="${5//--set /}" '
        { gsub(/"[^"]*"/, "quoted") }  # a camera has commas
        FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
        { sub(/.*\//, "", $column["scene"]) }
        $column["scene"] == scene && $column["width"] == width && $column["family"] == family {
            sum = 0
            count = split($column["passes_ms"], all, " ")
            for (i = 1; i <= count; ++i) { split(all[i], pass, "="); if (pass[1] ~ passes) sum += pass[2] }
            print unit == "ms" ? sum : sum / $column["cost_ms"] * $column["ratio_learnopengl"]
        }' "$work"/*.csv
}
over() {  # UNIT PASSES SCENE WIDTH CONFIG SCENE WIDTH CONFIG: the median over rounds of their ratio
    paste <(rounds_of "$1" "$2" "$3" "$4" "$5") <(rounds_of "$1" "$2" "$6" "$7" "$8") | awk '{ print $1 / $2 }' | sort -g |
        awk '{ ratios[NR] = $1 } END { r = ratios[(NR + 1) / 2]; printf r < 3 ? "%.1f" : "%.0f", r }'
}
gtao() { over ms "$1" "$2" "$3" gtao "$4" "$5" gtao; }  # PASSES SCENE WIDTH SCENE WIDTH
# Of one view, in units of learnopengl, which takes turns with each config: that is steadier.
configs() { over ratio "$1" "$2" "$3" "$4" "$2" "$3" "$5"; }  # PASSES SCENE WIDTH CONFIG CONFIG
forward_over_deferred() { configs . "$1" 480 "$frame $forward output=color" "$frame output=color"; }

time_rows() {
    local occlusion='^(foreground|ssao|filter)'
    measure_times
    row 'The cost depends on the resolution, not on the scene' 'SCS; all' \
        "\`gtao\`, 500,000 triangles of a floor over 1152 of the same: occlusion $(gtao "$occlusion" many.obj 480 few.obj 480), with the geometry $(gtao . many.obj 480 few.obj 480); room, 960x540 over 480x270: $(gtao "$occlusion" room 960 room 480); \`spheres\`, with sky, over room: $(gtao "$occlusion" spheres 480 room 480)" \
        'yes: more triangles cost the geometry pass alone; pixels of the sky cost next to nothing'
    row 'Deferred lighting makes SSAO cheaper' 'LearnOpenGL' \
        "\`hemisphere_bilateral\`, whole frames, \`lighting/forward\` over \`geometry/depth_only\` against deferred: a floor of 1152 triangles $(forward_over_deferred few.obj), room $(forward_over_deferred room), the floor of 500,000 $(forward_over_deferred many.obj)" \
        'where triangles are many: forward draws them twice, deferred lights every pixel once more'
    row 'Two passes of 10 fetches are quicker than one of 25' 'thesis' \
        "\`thesis\`, room at 960x540, \`bilateral_2d\` over its own filter: the filter $(configs ^filter room 960 "thesis $one_pass" thesis), with the occlusion $(configs "$occlusion" room 960 "thesis $one_pass" thesis)" \
        'yes'
}

{
    row "claim by ${table}s" source measured holds
    row --- --- --- ---
    "${table}_rows"
} >"$work/table"

awk -v table="$work/table" '
    BEGIN { getline head <table; close(table) }
    $0 == head { while ((getline line <table) > 0) print line; skip = 1 }
    !/^\|/ { skip = 0 }
    !skip { print }' docs/claims.md >"$work/page.md"
cmp -s "$work/page.md" docs/claims.md || { cp -- "$work/page.md" docs/claims.md; echo "changed docs/claims.md"; }
