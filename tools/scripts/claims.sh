#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Measures what authors claim of ambient occlusion and writes the table of docs/claims.md, by errors alone: times are
# of a device. Half a minute, and a minute more where the references are not cached. CREVICE may name a built command;
# otherwise the release preset is built.
#
#   tools/scripts/claims.sh
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

draw() {  # FILE SCENE CONFIG [OPTION...]
    local file=$1 scene=$2 config=$3
    shift 3
    "$CREVICE" render "$config" --scene "$scene" --size 480x270 --set radius=1 --out "ao=$work/$file" "$@" >"$work/log" 2>&1 ||
        { cat "$work/log" >&2; exit 1; }
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

for scene in room spheres plane; do
    "$CREVICE" reference --scene "$scene" --size 480x270 --radius 1 --out "$work/$scene.pfm" >"$work/log" 2>&1
done
kernel=/generated/kernel
noise=/generated/rotation_noise/count
tile() { error room hemisphere_box --set samples=8 --set "$noise=$1" --set "blur_size=$1"; }
noisy() {  # SETTING...: rmse against ground truth, and that against many rotated samples
    printf '%s (%s)' "$(error room hemisphere_box "${@/#/--set=}")" "$(difference rmse ao.pfm many.pfm)"
}
unrotated() { noisy "samples=$1" "$noise=1" blur_size=1; }
draw many.pfm room hemisphere_box --set samples=250 --set blur_size=1
draw one.pfm room thesis --set filter/bilateral=filter/bilateral_2d
draw two.pfm room thesis

row() { printf '| %s | %s | %s | %s |\n' "$@"; }
{
    row claim source measured holds
    row --- --- --- ---
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
        'yes: the wider filter blurs away what more directions gain'
    row 'Without rotation about 200 samples are needed, with it and a filter 16' 'Wikipedia, "Screen space ambient occlusion"' \
        "\`hemisphere_box\`, room, and from its own picture of 250 rotated samples unfiltered: 16 rotated and filtered $(noisy samples=16); unrotated, unfiltered 64 $(unrotated 64), 128 $(unrotated 128), 250 $(unrotated 250)" \
        'yes: 128 are noisier than the 16, and 250 are not'
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
} >"$work/table"

awk -v table="$work/table" '
    /^\| claim \|/ { while ((getline line <table) > 0) print line; skip = 1 }
    !/^\|/ { skip = 0 }
    !skip { print }' docs/claims.md >"$work/page.md"
cmp -s "$work/page.md" docs/claims.md || { cp -- "$work/page.md" docs/claims.md; echo "changed docs/claims.md"; }
