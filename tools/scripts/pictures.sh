#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of README.md and docs: the room at radius 1. Half a minute.
#
#   tools/scripts/pictures.sh          into docs/reference/pictures: look at them, and at git diff, before you commit
#   tools/scripts/pictures.sh --check  changes nothing; exit code 1 where a picture is not what is drawn now
#
# CREVICE may name a built command; otherwise the release preset is built. On another device than the
# software renderer pictures may differ by rounding, which --check lets pass.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

shown=docs/reference/pictures
case ${1:-} in
    "") check=false ;;
    --check) check=true ;;
    *) echo "usage: tools/scripts/pictures.sh [--check]" >&2; exit 2 ;;
esac
source tools/scripts/built_crevice.sh
mkdir "$work/pictures"

main='eye=0.1,1.15,2.1;at=-0.1,0.4,-0.9;fov=50'  # no sky: the ground truth is known everywhere
near='eye=0.1,1.15,2.1;at=-0.6,0.33,-0.9;fov=24'  # the bunny, the cube and the corner behind them

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

# docs/reference/methods.md
quietly "$CREVICE" reference --scene room --size 480x270 --camera "$main" --radius 1 \
    --out "$work/pictures/ground_truth.png"
for config in gtao sao; do whole "$config" ao "$config"; done
half hemisphere_learnopengl ao learnopengl
half sphere_ogldev45 ao ogldev45
half bitmask ao bitmask
half ssdo_on color ssdo --set bounce=4

corner='eye=-0.2,0.5,0.3;at=-0.9,0.2,-0.6;fov=40'  # much of what occludes is off the screen
off_screen() { draw "off_screen_$1" 320x180 "$corner" ao "$1" --set radius=1.5; }
off_screen balanced
off_screen balanced_far
off_screen vxao
quietly "$CREVICE" reference --scene room --size 320x180 --camera "$corner" --radius 1.5 \
    --out "$work/pictures/off_screen_truth.png"

# README.md
half presets_balanced ao balanced
half balanced_no_ao color balanced --set ambient=0.5 --set display=no_ao
half balanced_lit color balanced --set ambient=0.5

# docs/reference/filters.md
for filter in none upsample; do
    made "gtao_$filter" "\"geometry/depth_normal\",\"ssao/gtao\",\"filter/$filter\""
    detail "filters_$filter" ao "$work/gtao_$filter.json"
done

# docs/reference/temporal.md
made gathered '"geometry/depth_normal","ssao/gtao","filter/temporal"'
detail temporal_1 ao "$work/gathered.json" --frames 1 --set slices=1 --set steps=4 --set rotation=gradient
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
