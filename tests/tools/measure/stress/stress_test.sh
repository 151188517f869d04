#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# crevice stress as a user's shell sees it: what is broken on purpose is reported at the right case.
#   stress_test.sh CREVICE
set -euo pipefail
checkout=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../../.." && pwd)
source "$(dirname -- "${BASH_SOURCE[0]}")/../../../support/cli_checks.sh"

# --- arguments, one message each ---
expect 0 '^plane_near_far .*' stress gtao --list
expect 2 "there is no case 'plane_fvo'" stress gtao --case plane_fvo
expect 1 "there is no config 'gtoa'|'gtoa'" stress gtoa --list
expect 1 "" stress gtao --size 12 --list

small=(--size 64x36)
probe "$crevice" stress gtao --case no_op "${small[@]}" --out probe
check "no-ops of gtao hold" test "$got" -eq 0

expect 0 '"failures": 0' stress gtao --case no_op "${small[@]}" --out probe --json
expect_json

# --- a shader that takes the root of what is below 0 near four points ---
mkdir broken
cat >broken/nan.frag <<'GLSL'
#version 300 es
precision highp float;
uniform highp sampler2D ao;
in vec2 uv;
layout(location = 0) out float ao_filtered;
void main()
{
    vec2 away = fract(uv * 2.0) - 0.5;
    ao_filtered = texture(ao, uv).r + sqrt(min(length(away) - 0.1, 0.0));
}
GLSL
cat >broken/nan.json <<'JSON'
{
  "format": 1, "name": "nan", "description": "Writes NaN.",
  "extends": ["geometry/depth_normal", "ssao/hemisphere"],
  "targets": {"ao_filtered": {"format": ["r32f", "r16f"]}},
  "shaders": {"spoil": {"vertex": "common/fullscreen.vert", "fragment": "./nan.frag"}},
  "passes": {"spoil": {"type": "fullscreen", "shader": "spoil", "color": ["ao_filtered"]}},
  "outputs": {"ao": "ao_filtered"}
}
JSON
expect 5 "plane_fov +breaks at 45: pass 'spoil' writes [0-9]+ pixels that are not finite into 'ao_filtered'" \
    stress broken/nan.json --case plane_fov "${small[@]}" --out nan
check "a failure has its picture" test "$(find nan/pictures -name '*.png' | wc -l)" -eq 8

# --- occlusion that is lost beyond 20 of the world's units ---
cat >broken/absolute.frag <<'GLSL'
#version 300 es
precision highp float;
#include <surface>
uniform highp sampler2D ao;
in vec2 uv;
layout(location = 0) out float ao_filtered;
void main()
{
    highp vec3 point;
    float lost = viewPosition(uv, point) ? smoothstep(20.0, 50.0, -point.z) : 0.0;
    ao_filtered = mix(texture(ao, uv).r, 1.0, lost);
}
GLSL
sed 's/nan/absolute/; s/hemisphere/gtao/' broken/nan.json >broken/absolute.json
expect 5 '^  units +(VOID.*|holds from 1e-6 to 1e0); breaks at 1e1: mean change ' \
    stress broken/absolute.json --case units --case offset "${small[@]}" --out absolute
check "that is told first, in words" bash -c \
    'sed -n 2p stdout.txt | grep -qE "^  AO of .broken/absolute.json. .* where all lengths are more than 1e0 times as large: at 1e1, "'
check "an offset changes nothing of that" bash -c '! grep -E "^  offset .*breaks" stdout.txt'

# --- an edit against the run before it: a filter that is a texel off fails no case, and differs ---
mkdir edited
cp -r -- "$checkout/effects" "$checkout/configs" edited
sed -i 's/uv \* size - 0.5;/uv * size + 0.5;/' edited/effects/filter/shaders/upsample.frag
echo '{"format": 1, "extends": ["geometry/depth_normal", "ssao/gtao", "filter/upsample", "lighting/deferred"]}' >low.json
samples=(stress low.json --case samples --quick --size 128x72)  # ssao/march_missing would mend it
"$crevice" "${samples[@]}" --out before >stdout.txt 2>stderr.txt || true
expect 0 '^0 steps are worse than known' "${samples[@]}" --out before --against before
expect 5 'low.json, samples, 16: error .*, was |[1-9] steps are worse than known' "${samples[@]}" --effects edited \
    --out after --against before
expect 1 "no results can be read from 'nowhere/known.jsonl'" "${samples[@]}" --out before --against nowhere
finish
