#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The crevice command where it draws: pictures on one backend, and the README's own filter.
#   cli_gl_test.sh CREVICE README BACKEND
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/../../support/cli_checks.sh"
readme=$2
backend=$3

small=(--scene corner --size 96x64 --backend "$backend")
probe "$crevice" render learnopengl "${small[@]}"
check "render writes color.png by default" test -s color.png

expect 0 'wrote ao.pfm' render learnopengl "${small[@]}" --out color=lit.png --out ao=ao.pfm
check "both files are there" test -s lit.png -a -s ao.pfm
expect 0 '"first_frame_ms"' render learnopengl "${small[@]}" --out ao=ao.png --json
expect_json
expect 0 '"warm_ms"' render learnopengl "${small[@]}" --warm --out ao=ao.png --json
expect 0 'wrote' render learnopengl "${small[@]}" --out target.ao=raw.pfm --out normal=normal.pfm \
    --out view_normal=normal.png --out depth=depth.pfm
expect 5 'over' compare raw.pfm ao.pfm --max-rmse 0.0001

# Another engine's depth, of any projection, is as good as its mesh.
view='fov=50;near=0.1;far=30'
expect 0 'wrote' render mobile "${small[@]}" --camera "eye=2,1.5,3;at=0,0.5,0;$view" --set guard_band=1 --out ao=mesh.pfm \
    --out target.depth=depth.exr --out view_depth=bytes.png
expect 0 'wrote own.pfm' render mobile --import depth=depth.exr --projection "$view" --set radius=0.5 \
    --backend "$backend" --out ao=own.pfm
expect 0 'rmse' compare own.pfm mesh.pfm --max-rmse 0.01
expect 0 'radius 40 pixels' render mobile --import depth=depth.exr --projection "$view" --backend "$backend"
expect 1 'CV7005.*8 bits' render mobile --import depth=bytes.png --projection "$view" --backend "$backend"

# A path's last frame is the picture without one; all of its frames are there, and no others.
expect 0 'wrote path_%02d.pfm' render gtao "${small[@]}" --path pan --frames 3 --out ao=path_%02d.pfm
check "a path writes as many frames as asked for" test "$(echo path_*.pfm)" = 'path_00.pfm path_01.pfm path_02.pfm'
expect 0 'wrote' render gtao "${small[@]}" --out ao=end.pfm
check "a path ends at the camera" cmp -s path_02.pfm end.pfm
expect 0 'wrote' render gtao_temporal "${small[@]}" --path still --frames 8 --out ao=path_%d.pfm
expect 0 'wrote' render gtao_temporal "${small[@]}" --frames 8 --out ao=end.pfm
check "a path keeps the history of its frames" cmp -s path_7.pfm end.pfm
expect 0 'frame 1 of a config that accumulates: --frames 32' render gtao_temporal "${small[@]}" --out ao=first.pfm
expect 1 'CV6010' render gtao_temporal "${small[@]}" --set host_velocity=true --out ao=end.pfm

# Intensity 0 leaves the whole AO chain out; the constant still fills the picture.
expect 0 'wrote' render learnopengl "${small[@]}" --set intensity=0 --out ao=open.pfm
expect 1 'CV7006|CV7005' compare open.pfm "$readme"
expect 0 'wrote' reference --scene corner --size 96x64 --radius 0 --rays 1 --out one.pfm
expect 0 'rmse' compare open.pfm one.pfm --max-abs 0

expect 0 'CV9003: the ambient occlusion is 1 everywhere' render learnopengl "${small[@]}" --set intensity=0 --out ao=open.pfm
expect 0 'intensity is 0' render learnopengl "${small[@]}" --set intensity=0 --out ao=open.pfm --json
expect_json

# A uniform block that a host alone fills explains the picture; the radius is not blamed.
expect 0 "skinned.glsl:8:.* CV6020: pass '.*' draws mesh '.*' with the uniform block 'Bones'" \
    render "$(dirname -- "$readme")/tools/examples/host_draws/skinned.json" "${small[@]}" --out ao=skinned.png
check "no other cause is named" bash -c '! grep -qE "CV(4001|7008|9003)" stderr.txt'

# A number is printed, wherever it stands.
expect 0 'doubt_rmse is 0.' render mobile "${small[@]}" --out doubt_rmse --out ao=numbered.png

# A picture that shows no ambient occlusion says why.
expect 0 'warning CV7008: the camera sees no surface' render gtao "${small[@]}" \
    --camera 'eye=0,1,100;at=0,1,200' --out color=lit.png
expect 0 'wrote' render gtao "${small[@]}" --out color=lit.png
check "a picture that shows it has nothing to say" eval '! grep -q warning stderr.txt'

# On a host's textures, which the command draws: by the option, a plus, or the config's own imports.
expect 0 'wrote ao.png' render mobile "${small[@]}" --host-depth
expect 0 'wrote' render mobile "${small[@]}" --host-depth --out ao=option.pfm --save-patch hosted.json
expect 0 'wrote' render mobile "${small[@]}" --set +geometry/host_depth --out ao=plus.pfm
printf '%s' '{"format": 1, "extends": ["mobile", "geometry/host_depth"]}' >host.json
expect 0 'wrote' render host.json "${small[@]}" --out ao=own.pfm
expect 0 'wrote' render hosted.json "${small[@]}" --out ao=saved.pfm
for file in plus own saved; do check "$file.pfm is the picture on a host's depth" cmp option.pfm "$file.pfm"; done
# A texture that a config imports is a picture beside it, and none elsewhere.
mkdir imports
printf '%s' '{"format": 1, "extends": ["gtao"], "imports": {"dirt": {"type": "texture", "format": "r8"}},
    "shaders": {"lit": {"vertex": "common/fullscreen.vert", "fragment": "./lit.frag"}}, "targets": {"lit": {"format": "r8"}},
    "passes": {"lit": {"shader": "lit", "color": ["lit"]}}, "outputs": {"lit": "lit"}}' >imports/mine.json
printf '%s\n' '#version 300 es' 'precision highp float;' 'uniform mediump sampler2D dirt;' 'in vec2 uv;' \
    'layout(location = 0) out float lit;' 'void main() { lit = texture(dirt, uv).r; }' >imports/lit.frag
cp ao.png imports/dirt.png
expect 0 'wrote lit.png' render imports/mine.json "${small[@]}" --out lit=lit.png
ln -sf ../ao.png imports/dirt.png
expect 1 'mine.json:1:.*CV1204.*outside of' render imports/mine.json "${small[@]}" --out lit=lit.png
expect 0 'wrote lit.png' render imports/mine.json "${small[@]}" --out lit=lit.png --root .
# That a module imports, too: here a panorama of one blue pixel, as .hdr.
printf '{"format": 1, "extends": ["balanced", "lighting/metallic_roughness"]}\n' >imports/lit.json
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x10\x20\xff\x82\x10\x20\xff\x82' >sky.hdr
expect 0 'wrote grey.pfm' render imports/lit.json "${small[@]}" --out reflections=grey.pfm
cp sky.hdr imports/environment.hdr
expect 0 'environment is imports/environment.hdr' render imports/lit.json "${small[@]}" --out reflections=blue.pfm
expect 0 'environment is sky.hdr' render balanced+lighting/metallic_roughness "${small[@]}" --texture environment=sky.hdr \
    --out reflections=same.pfm
expect 5 'over' compare blue.pfm grey.pfm --max-rmse 0.1
expect 0 'rmse' compare blue.pfm same.pfm --max-rmse 0
expect 2 'help: write --texture environment=FILE' render imports/lit.json "${small[@]}" --texture sky=sky.hdr
rm imports/dirt.png && mkfifo imports/dirt.png
expect 1 'CV7005.*no regular file' render imports/mine.json "${small[@]}" --out lit=lit.png
expect 0 'wrote' render mobile "${small[@]}" --set guard_band=1 --out ao=drawn.pfm
expect 0 'rmse' compare option.pfm drawn.pfm --max-abs 0.01
expect 1 "CV2209.*color" render mobile "${small[@]}" --host-depth --out color=lit.png
expect 0 'rmse' bench --config high --host-depth=normals --scene corner --size 64x36 --rays 8 --repeats 1 \
    --no-cache --backend "$backend" --out bench_host
expect 0 'meshes +not in this config: it draws nothing: the host does' stress gtao --host-depth=log --case meshes \
    --case plane_fov --quick --size 64x36 --no-cache --backend "$backend" --out stress_host

# What was set is saved as a config of its own, which draws the same picture.
mkdir -p saved
expect 0 'wrote' render thesis "${small[@]}" --variant lambert --set radius=0.8 --set power=1 \
    --set /generated/kernel/seed=7 --set /views/view_ao=null --out color=set.png --save-patch saved/one.json
expect 0 'wrote' render saved/one.json "${small[@]}" --out color=saved.png
check "a saved patch draws the same picture" cmp set.png saved.png
expect 0 'CV4004.*range_check' render thesis "${small[@]}" --set ssao/hemisphere=ssao/gtao --out color=set.png \
    --save-patch saved/swapped.json
expect 0 'wrote' render saved/swapped.json "${small[@]}" --out color=saved.png
check "a saved patch swaps the module too" cmp set.png saved.png
expect 0 'wrote' render quality "${small[@]}" --set quality=low --set steps=9 --out color=set.png --save-patch level.json
expect 0 'wrote' render level.json "${small[@]}" --out color=saved.png
check "a saved patch keeps what was set over a level" cmp set.png saved.png

# Mediump as on a phone: another picture, by little. A build without glslang says so.
if "$crevice" render learnopengl "${small[@]}" --precision half --out color=half.png 2>stderr.txt; then
    expect 0 'wrote' render learnopengl "${small[@]}" --precision full --out color=full.png
    expect 5 'over' compare full.png half.png --max-abs 0
    expect 0 'rmse' compare full.png half.png --max-rmse 0.004
    expect 0 'every value is written, finite and in range' doctor learnopengl --scene corner --size 96x64 --backend "$backend" \
        --precision half
else
    check "a build that cannot choose a precision says so" grep -q CV6012 stderr.txt
fi

# Programs are kept in a folder, and then none is compiled; where the driver gives none it says so.
cached=(render learnopengl "${small[@]}" --program-cache kept/programs)
expect 0 '^0 of [0-9]+ programs|driver has no program binaries' "${cached[@]}" --out color=cold.png
if [[ -n $(ls kept/programs) ]]; then
    programs=$(ls kept/programs | wc -l)
    expect 0 "\"found\": $programs" "${cached[@]}" --out color=warm.png --json
    for file in kept/programs/*; do printf 'garbage' >"$file"; done
    expect 0 "^0 of $programs programs" "${cached[@]}" --out color=garbage.png
    for file in warm garbage; do check "$file programs draw the same" cmp -s cold.png "$file.png"; done
fi
rm -rf kept && printf 'a file' >kept
expect 4 "CV7007: 'kept/programs'" "${cached[@]}" --out color=never.png

from_readme mine.json
from_readme cross.json effects/README.md
from_readme cross.frag effects/README.md
expect 0 'wrote' render mine.json "${small[@]}"
expect 0 'wrote' render cross.json "${small[@]}" --out ao=cross.pfm
expect 5 'over' compare cross.pfm ao.pfm --max-rmse 0.0001

# The whole effect in one file is what the modules make.
whole=$(dirname -- "$readme")/docs/reference/learnopengl_without_modules.json
expect 0 'wrote' render "$whole" "${small[@]}" --out color=whole.png
expect 0 'wrote' render learnopengl "${small[@]}" --out color=modules.png
check "both have one picture" cmp -s whole.png modules.png
check "without modules it takes at most 110 lines" test "$(wc -l <"$whole")" -le 110

# Live editing: a save draws again, a mistake leaves the picture, and its mending draws again.
"$crevice" render mine.json "${small[@]}" --out ao=live.pfm --watch >watch.txt 2>&1 </dev/null &
watcher=$!
reported() {
    local count=$1 text=$2
    for _ in {1..200}; do
        (($(grep -c -- "$text" watch.txt) >= count)) && return 0
        sleep 0.1
    done
    return 1
}
check "the watch begins" reported 1 'watching'
cp live.pfm before.pfm
sed -i 's/0\.8/0.3/' mine.json
check "a save draws again" reported 1 'drawn again'
check "with the new value" eval '! cmp -s live.pfm before.pfm'
cp live.pfm before.pfm
sed -i 's/"radius"/"raduis"/' mine.json
check "a mistake is reported" reported 1 'CV4004'
check "and leaves the picture" reported 1 'the last pictures stay'
check "as it was" cmp -s live.pfm before.pfm
sed -i 's/"raduis"/"radius"/' mine.json
check "its mending draws again" reported 2 'drawn again'
got=0
kill -TERM "$watcher" && wait "$watcher" || got=$?
check "an interrupt ends the watch in peace" test "$got" = 0

# The doctor: a healthy frame, a pass that writes what is no number, and why a picture is plain.
expect 0 'every value is written, finite and in range' doctor gtao_temporal "${small[@]}"
expect 0 '"state": "varies"' doctor learnopengl "${small[@]}" --json
expect_json
sed -i 's|ao_filtered = sum / 5.0;|ao_filtered = sqrt(sum / 5.0 - 0.9);|' cross.frag
expect 5 "cross.json:.*CV9001: pass 'cross' writes [0-9]+ of 6144 pixels" doctor cross.json "${small[@]}"  # r8 has no NaN
sed -i 's|sqrt(sum / 5.0 - 0.9)|sum / 5.0 + 0.7|' cross.frag
expect 5 "CV9004: pass 'cross' writes [0-9]+ of 6144 pixels out of range .*: 1.7" doctor cross.json "${small[@]}"
expect 0 'intensity is 0, so ao is 1' doctor learnopengl "${small[@]}" --set intensity=0
expect 0 'pixels at the median depth' doctor gtao "${small[@]}" --set radius=1e-6
# A model in millimetres, whose radius nobody sets; one that somebody sets is theirs.
printf 'v %s 0 %s\n' -1000 -1000 1000 -1000 1000 1000 -1000 1000 >millimetres.obj
printf '%s\n' 'v -1000 1000 -1000' 'v 1000 1000 -1000' 'f 4 3 2 1' 'f 1 2 6 5' >>millimetres.obj
millimetres=(--scene millimetres.obj --size 96x64)
expect 0 'radius 5 % of the scene = 150' render gtao "${millimetres[@]}" --backend "$backend" --out ao=ao.pfm
check "a model in millimetres shows AO at default settings" test "$(grep -c CV stderr.txt)" = 0
expect 0 'CV9003.*radius 0.5' render gtao "${millimetres[@]}" --backend "$backend" --set radius=0.5 --out ao=ao.pfm
expect 0 'radius 5 % of the scene = 150' explain gtao "${millimetres[@]}" --why radius
expect 0 '8 pixels at the median depth' reference "${millimetres[@]}" --radius 8px --rays 1 --out one.pfm
expect 0 'sees no surface' doctor gtao "${small[@]}" --camera 'eye=0,1,100;at=0,1,200'
# ... and AO and light against what they must be.
checkout=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../.." && pwd)
# faulty FILE EXPRESSION: a copy of what is shipped with one fault.
faulty() {
    rm -rf faulty && mkdir faulty && cp -r -- "$checkout/effects" "$checkout/configs" faulty
    sed -i "$2" "faulty/effects/$1"
}
faulty ssao/shaders/march.frag 's/^    ao = visibilityFrom(.*/&\n    if (!known) ao = 0.0;/'
expect 5 'CV9005: gtao, background, from afar: breaks: 0 where no surface is seen' doctor gtao "${small[@]}" --effects faulty
faulty lighting/shaders/blinn_phong.glsl 's/max(dot(s.normal, direction), 0.0)/abs(dot(s.normal, direction))/'
expect 5 'CV9005: gtao, light_behind, a directional light: breaks' doctor gtao "${small[@]}" --effects faulty
faulty lighting/shaders/deferred.frag 's/float open = shownOpen(.*/float open = 1.0;/'
expect 5 'CV9005: gtao, ambient_alone, occlusion: breaks' doctor gtao "${small[@]}" --effects faulty
faulty ssao/shaders/gtao.glsl 's/bool inside = far < 1.0;/bool inside = far < 4.0;/'
expect 5 'CV9005: gtao, the scene, .*: error 0.[0-9]*, was 0' doctor gtao "${small[@]}" --effects faulty
echo '{"format": 1, "extends": ["gtao"], "params": {"power": 8}}' >strong.json
expect 5 'CV9005: strong.json, the scene, .*`gtao` has 0' doctor strong.json "${small[@]}"
modules='"geometry/depth_normal", "ssao/gtao", "filter/none", "lighting/deferred"'
echo "{\"format\": 1, \"extends\": [$modules]}" >apart.json
expect 0 'AO and light are as they must be' doctor apart.json "${small[@]}"
echo "{\"format\": 1, \"extends\": [$modules], \"params\": {\"power\": 64}}" >apart.json
expect 5 'CV9005: apart.json, the scene, ' doctor apart.json "${small[@]}"

printf 'void main() { nonsense; }\n' >>cross.frag
expect 1 'cross.frag:[0-9]+.*error CV50' render cross.json "${small[@]}" --out ao=never.png
expect 1 'CV4005|CV6007' render learnopengl --scene corner --backend "$backend" --size 99999x99999 \
    --out ao=never.png
check "a failed render leaves no file, whole or half" test -z "$(ls -A | grep never || true)"
finish
