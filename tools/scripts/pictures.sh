#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of README.md and docs/methods: one view of the room, radius 1, through each method. Half a minute.
#
#   tools/scripts/pictures.sh          into docs/methods/pictures: look at them, and at git diff, before you commit
#   tools/scripts/pictures.sh --check  changes nothing; exit code 1 where a picture is not what is drawn now
#
# CREVICE may name a built command; otherwise the release preset is built. On another device than the
# software renderer pictures may differ by rounding, which --check lets pass.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

shown=docs/methods/pictures
case ${1:-} in
    "") check=false ;;
    --check) check=true ;;
    *) echo "usage: tools/scripts/pictures.sh [--check]" >&2; exit 2 ;;
esac
source tools/scripts/built_crevice.sh
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
mkdir "$work/pictures"

main='eye=0.1,1.15,2.1;at=-0.1,0.4,-0.9;fov=50'  # no sky: the ground truth is known everywhere
near='eye=0.1,1.15,2.1;at=-0.6,0.33,-0.9;fov=24'  # the bunny, the cube and the corner behind them

# Shows what a command prints only where it fails.
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; return 1; }; }

# draw NAME SIZE CAMERA OUTPUT CONFIG ARGUMENTS...
draw() {
    local name=$1 size=$2 camera=$3 output=$4 config=$5
    shift 5
    quietly "$CREVICE" render "$config" --scene room --size "$size" --camera "$camera" --set radius=1 \
        "$@" --out "$output=$work/pictures/$name.png"
}
# One picture wide, or one of two side by side.
whole() { draw "$1" 480x270 "$main" "${@:2}"; }
half() { draw "$1" 320x180 "$main" "${@:2}"; }
detail() { draw "$1" 320x180 "$near" "${@:2}"; }

# made NAME MODULES: a config of one's own.
made() { printf '{"format":1,"name":"%s","extends":[%s]}' "$1" "$2" >"$work/$1.json"; }

quietly "$CREVICE" reference --scene room --size 480x270 --camera "$main" --radius 1 \
    --out "$work/pictures/ground_truth.png"
for config in gtao hbao hbao_plus sao; do whole "$config" ao "$config"; done
for config in learnopengl lettier thesis; do half "hemisphere_$config" ao "$config"; done
half sphere_ogldev45 ao ogldev45
half sphere_box ao sphere_box
for config in bitmask bitmask_layers; do half "$config" ao "$config"; done
half ssdo_off color ssdo --set indirect=false --set bounce=4
half ssdo_on color ssdo --set bounce=4
half lighting_no_ao color gtao --set display=no_ao
half lighting_everything color gtao --set ao_on=everything
half lighting_ambient color gtao
draw stereo 240x180 "$near" color gtao --stereo 0.065
for config in mobile_low balanced high reference; do half "presets_$config" ao "$config"; done

half balanced_no_ao color balanced --set ambient=0.5 --set display=no_ao  # the README's
half balanced_lit color balanced --set ambient=0.5

for filter in none box edges3x3 upsample; do
    made "gtao_$filter" "\"geometry/depth_normal\",\"ssao/gtao\",\"filter/$filter\""
    detail "filters_$filter" ao "$work/gtao_$filter.json"
done
for geometry in depth_normal depth_only; do
    made "$geometry" "\"geometry/$geometry\",\"ssao/gtao\",\"filter/edges3x3\""
    detail "inputs_$geometry" ao "$work/$geometry.json"
done
made gathered '"geometry/depth_normal","ssao/gtao","filter/temporal"'
for frames in 1 32; do
    detail "temporal_$frames" ao "$work/gathered.json" --frames $frames \
        --set slices=1 --set steps=4 --set rotation=gradient
done
detail temporal_filtered ao gtao_temporal --frames 32

if ! $check; then
    mkdir -p "$shown"
    rm -f -- "$shown"/*.png
    cp -- "$work"/pictures/*.png "$shown"
    echo "wrote $(ls "$shown" | wc -l) pictures into $shown"
    exit 0
fi

stale=0
for name in $( (ls "$work/pictures"; ls "$shown") | sort -u); do
    if ! "$CREVICE" compare "$work/pictures/$name" "$shown/$name" --max-rmse 0.005 >/dev/null 2>&1; then
        echo "$shown/$name is not what is drawn now"
        stale=$((stale + 1))
    fi
done
if ((stale)); then
    echo "If that is meant: tools/scripts/pictures.sh, and say why in the commit."
    exit 1
fi
echo "all pictures are what is drawn now"
