#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The crevice command where no GL is needed: exit codes, messages, what it prints.
#   cli_test.sh CREVICE README
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/../../support/cli_checks.sh"
readme=$2

# --- usage ---
expect 2 "CV8001.*no camera path 'pam'" render gtao --path pam
expect 2 "CV8001: the file 'ao.png'.*place for the frame" render gtao --path pan --out ao=ao.png
expect 2 'names no file for the frames' render gtao --path pan --out ao
expect 2 'excludes --watch' render gtao --path pan --watch
expect 0 '^crevice 0\.1\.0$' --version
expect 0 'Exit codes' --help
for command in render validate explain compare reference cost; do
    expect 0 'Examples:' "$command" --help
done
expect 2 'CV8001'
expect 2 "CV8001: there is no command 'paint'" paint learnopengl
expect 2 "did you mean 'render'" rendr learnopengl
expect 2 "did you mean '--variant'" validate learnopengl --varient sound
expect 2 'write crevice report' compare-bench a b
expect 2 'crevice render --help' render
expect 2 'CV8001' render learnopengl --backend vulkan
expect 2 'CV8001' render learnopengl --effects nowhere
expect 2 'CV8001.*two --out' render learnopengl --out color=a.png --out ao=./a.png
expect 2 'CV8001' validate
expect 2 'CV8001' explain learnopengl --format svg
expect 2 'CV8001' compare a.png
expect 2 'CV8001.*--max-abs' compare a.png b.png --max-abs two

expect 2 "the command comes first: crevice render balanced" balanced render
expect 2 "write --host-depth=normals" render gtao --host-depth normals
expect 2 'CV8001.*--up.*y' render gtao --scene plane --up x
expect 1 'CV7005.*nix.exr' render gtao --import depth=nix.exr
expect 2 "'depth=' is not NAME=FILE" render gtao --import depth=
expect 2 'CV8001.*requires --import' render gtao --projection 'fov=50'
expect 2 "write --config mine.json" bench mine.json
expect 2 "long dash" render gtao –size 320x180
expect 2 "write two hyphens: --size" render gtao —size 320x180
expect 2 "'4x16' is not a number above 0, without a unit, as in 4,16" bench --config gtao --samples 4x16 --list
expect 2 "not a number above 0" choose results.jsonl --error nan
expect 2 'write --set radius=0.8;' render gtao --set radius 0.8
expect 1 'one config at a time' bench --config gtao,sao
expect 2 'as one word: 10m' bench --config gtao --time-budget 10 minutes --list
expect 2 'seconds from 1 to' render gtao --import-time 500ms
expect 4 'HOME' render gtao --scene plane --out 'ao=~/x.png'
expect 2 'with its unit' bench --config gtao --time-budget 10 --list
expect 2 'without a unit, bytes=' validate gtao --limit bytes=1MiB
mkdir empty
expect 1 "'empty' is a folder" render empty

# --- validate ---
expect 0 'learnopengl: ok \([0-9]+ passes' validate --all
expect 0 '"ok": true' validate learnopengl --json
expect 0 'textures at 64x36' validate mobile --size 64x36
expect 1 'CV1209.*at most 3' validate mobile --limit passes=3
expect 1 'CV1209.*MiB' render mobile --limit bytes=1000
figure() { sed -nE 's/.*--limit bytes=([0-9]+).*/\1/p' stdout.txt stderr.txt; }
for scene_uses_more in mobile balanced; do
    expect 1 'CV1209.*MiB' validate $scene_uses_more --limit bytes=1000
    check "the excess is told once" test "$(grep -c CV1209 stderr.txt)" -eq 1
    bytes=$(figure)
    expect 0 'ok' validate $scene_uses_more --limit bytes="$bytes"
    expect 1 'CV1209' validate $scene_uses_more --limit bytes=$((bytes - 1))
done
expect 2 "did you mean 'passes'" validate mobile --limit pases=3
expect 0 'thesis variant ambient_only: ok' validate thesis --variant ambient_only
printf '%s' '{"format": 1, "extends": ["learnopengl"], "variants": {"low": {"parms": {}}}}' >variant.json
expect 1 "variant.json:.*CV3001: found the key 'parms'" validate variant.json
expect 1 'CV1205' validate thesis --variant winter
expect 1 'CV1201.*' validate learnopengle
printf '{ "format": 1, "name": "broken", "extends": ["learnopengl"],\n  "pases": {} }\n' >broken.json
expect 1 'broken.json:2:3: error CV3001' validate broken.json
expect 1 '"code": "CV3001"' validate broken.json --json
expect 1 'broken: ok|learnopengl: ok' validate broken.json learnopengl
mkdir -p windows/shaders
printf '{"format": 1, "extends": [".\\\\base.json"]}' >windows/mine.json
printf '{"format": 1, "extends": ["gtao", "./base.frag"]}' >windows/shader.json
printf '{"format": 1, "extends": ["gtao"], "shaders": {"filter": {"fragment": ".\\shaders\\box.frag"}}}' >windows/box.json
printf '{"format": 1, "extends": ["gtao"]}' >windows/base.json
touch windows/base.frag windows/shaders/box.frag
expect 1 "write './base.json'" validate windows/mine.json
expect 1 "mine.json:1:27|write './base.json'" validate windows/shader.json
expect 1 "write './shaders/box.frag'" validate windows/box.json
printf '{ "format": 1,' >cut.json
expect 1 'cut.json:1:[0-9]+: error CV1001' validate cut.json

# --- the README's examples ---
from_readme mine.json
from_readme cross.json effects/README.md
from_readme cross.frag effects/README.md
expect 0 'cross.json: ok' validate cross.json
expect 0 'mine.json:[0-9]+:[0-9]+' explain mine.json --why radius

# --- modules and configs on disk hide the embedded ones ---
mkdir -p checkout/configs checkout/effects/ssao
sed 's/"mine"/"learnopengl"/; s/"extends".*/"extends": ["hemisphere_box"],/' mine.json \
    >checkout/configs/learnopengl.json
expect 0 'checkout/configs/learnopengl.json:' explain learnopengl --why radius --effects checkout
expect 0 'effects/ssao/hemisphere.json:' explain learnopengl --why bias --effects checkout
cp mine.json checkout/configs/another.json
expect 0 'another: ok' validate --all --effects checkout

# --- on a host's depth: a forward config, a deferred one with layers, one with a history ---
configs=(mobile high balanced_temporal)
[[ -z ${CREVICE_NIGHTLY:-} ]] || configs+=(balanced gtao quality reference)
for config in "${configs[@]}"; do
    for words in --host-depth --host-depth=normals --host-depth=linear --host-depth=log_normals; do
        expect 0 "ok \\([0-9]+ passes" validate "$config" "$words"
    done
done
expect 0 "module geometry/second_layer \\(replaced\\): it needs 'scene', which 'geometry/host_depth_normal" \
    explain high --host-depth=normals
expect 2 'CV8001.*--host-depth' explain mobile --host-depth=colour
expect 1 "CV1201.*geometry/hostdepth" explain mobile --set +geometry/hostdepth
expect 1 "CV1206.*\\+MODULE" explain mobile --set +
printf '%s' '{"format": 1, "extends": ["mobile", "geometry/host_depth"], "params": {"guard_band": 1.4}}' >banded.json
expect 1 "banded.json:1:[0-9]+: error CV4004: param 'guard_band'" validate banded.json

# --- inspect, list, params ---
printf 'newmtl leaf\nmap_Ks x.png\n' >wall.mtl
printf '%s\n' 'mtllib wall.mtl' 'v 0 0 0' 'v 6 0 0' 'v 6 8 0' 'v 0 8 0' 'usemtl leaf' 'f 1 2 3' 'f 1 3 4' >wall.obj
expect 0 'triangles 2,' inspect wall.obj
expect 0 '^surfaces +closed 0, open 1, sheets 0$' inspect wall.obj
expect 0 'diagonal 10, unit metres' inspect wall.obj
expect 0 'drawn without maps of highlights' inspect wall.obj
printf '%s\n' 'f 3 2 1' 'f 4 3 1' >>wall.obj
expect 0 '^surfaces +closed 0, open 0, sheets 1$' inspect wall.obj
expect 0 '^surfaces +closed 3, open 1, sheets 0$' inspect spheres
expect 0 '"kind": "point"' inspect spheres --json
expect_json
expect 1 'CV7001' inspect nowhere.obj
expect 0 'ssao/hbao_plus +Horizon-based' list estimators
expect 0 '^scenes \(5\) +corner' list
expect 2 "did you mean 'filters'" list filtrs --json
expect_json
expect 0 '^  radius +Radius +5% +0.5 +scene units.*--set' params gtao --set radius=5%
expect 0 '^  guard_band +Guard band +1.2 +1 .*configs/quality.json:[0-9]+' params quality --set quality=low
expect 0 '^  background_color +Background +0 0 1 +0.6 0.68 0.78 ' params gtao --set 'background_color=[0, 0, 1]'
expect 0 '"value": "tile"' params gtao --json
expect_json

# --- explain ---
expect 0 'geometry' explain learnopengl
expect 0 'digraph' explain learnopengl --format dot
expect 0 '' explain learnopengl --format json
expect_json
expect 0 'configs/ports/learnopengl.json:[0-9]+:[0-9]+: 0.5' explain learnopengl --why radius
expect 0 'command line|--set' explain learnopengl --why radius --set radius=2
expect 1 'CV2102' explain learnopengl --why params.radus
expect 0 '"places"' explain gtao --why radius --format json
expect_json
expect 0 '1920x1080' explain learnopengl --size 1920x1080
expect 0 'left out' explain learnopengl --set intensity=0 --output ao
expect 1 'CV2209' explain learnopengl --output aoo
expect 1 'CV4005' explain learnopengl --size 0x0
expect 0 'for each of 2 views' explain learnopengl --views 2

# --- render, up to where a context is needed ---
expect 1 'CV4005' render learnopengl --scene plane --size 640x
expect 1 'CV2209' render learnopengl --scene plane --out colour=a.png
expect 1 'CV1201' render nothing.json
expect 1 'CV7001' render learnopengl --scene nothing.glb
expect 1 'CV7004' render learnopengl --scene plane --camera left
expect 1 "or write --camera 'eye=" render learnopengl --scene plane --camera left
echo 'no scene' >broken.glb
expect 1 'CV7002' render learnopengl --scene broken.glb
printf 'ply\nformat ascii 1.0\nelement vertex 3\n' >cut.ply
expect 1 'CV7002.*ends within its header' render learnopengl --scene cut.ply
printf 'ply\nformat ascii 1.0\ncomment element face end_header\nelement vertex 3\n' >cut.ply  # Assimp never returns from it
expect 1 'CV7002.*longer than 1 s' render learnopengl --scene cut.ply --import-time 1
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >triangle.off
expect 1 'help: .*--any-format' explain learnopengl --scene triangle.off
expect 0 'plan' explain learnopengl --scene triangle.off --any-format
printf '{"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_texture_basisu"]}' >packed.gltf
expect 1 'CV7002.*KHR_texture_basisu' render learnopengl --scene packed.gltf
expect 4 'CV7007' render learnopengl --scene plane --out color=nowhere/a.png
expect 2 'CV8001.*json' render learnopengl --save-patch patch.txt
expect 0 'wrote saved.json' render learnopengl --scene nowhere --set radius=0.8 --save-patch saved.json
expect 2 'CV8001.*extend' render mine.json --save-patch ./mine.json
expect 4 'CV7007' render learnopengl --save-patch nowhere/patch.json
mkdir folder.png
expect 4 'CV7007' render learnopengl --scene plane --out color=folder.png
__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json \
    expect 3 'CV6001' render learnopengl --scene plane --backend egl --out color=a.png
check "a render that failed leaves no file" test ! -e a.png -a ! -e color.png

# --- schema ---
expect 0 'draft-07' schema
expect_json
expect 0 '^\| .radius|^\| key' schema --format markdown
expect 0 '"another"' schema --effects checkout

# --- reference and compare ---
expect 0 'wrote' reference --scene corner --size 32x24 --radius 0.5 --rays 16 --out ground_truth.pfm
expect 1 'CV4001' reference --scene corner --rays 0 --out never.pfm
timeout 20 "$crevice" reference --scene corner --size 64x64 --rays 262144 --out never.pfm >stdout.txt 2>stderr.txt || true
check "long work says how far it is, on no terminal too" grep -qE '^tracing \.\.\. [0-9]+ %$' stderr.txt
expect 4 'CV7007' reference --scene corner --out nowhere/ground_truth.pfm
expect 0 'rmse +0\.0+$' compare ground_truth.pfm ground_truth.pfm --max-rmse 0 --max-abs 0
expect 0 'wrote' reference --scene corner --size 32x24 --radius 5 --rays 16 --out far.pfm
expect 0 'psnr +[0-9.]+ dB' compare far.pfm ground_truth.pfm
expect 5 'over the limit' compare far.pfm ground_truth.pfm --max-rmse 0.001
expect 5 'over the limit' compare far.pfm ground_truth.pfm --max-abs 1/255
expect 0 '"rmse"' compare far.pfm ground_truth.pfm --json --diff diff.png
check "compare --diff writes a picture" test -s diff.png
expect 0 'wrote' reference --scene corner --size 16x24 --rays 1 --out small.pfm
expect 1 'CV7006' compare small.pfm ground_truth.pfm
expect 1 'CV7005' compare cut.json ground_truth.pfm
expect 2 'max-rmse' compare far.pfm ground_truth.pfm --max-rmse nan
printf 'Pf\n1 1\n-1\n\0\0\300\177' >nan.pfm
printf 'Pf\n1 1\n-1\n\0\0\200\077' >one.pfm
expect 1 'CV7005.*no pixel is left' compare one.pfm nan.pfm --max-rmse 0.1
printf 'Pf\n1 2\n-1\n\0\0\300\177\0\0\200\077' >half.pfm
printf 'Pf\n1 2\n-1\n\0\0\200\077\0\0\200\077' >ones.pfm
expect 5 'not finite' compare half.pfm ones.pfm --max-bad-fraction 1
finish
