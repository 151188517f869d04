#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# crevice cost with the compilers themselves, where tools/scripts/mobile_compilers.sh built them: figures, a check that
# holds, and one that fails once a shader spills. What it says without them is tested everywhere.
#   cost_test.sh CREVICE SOURCE
set -euo pipefail
source=$2
source "$(dirname -- "${BASH_SOURCE[0]}")/../../../support/cli_checks.sh"

mkdir none
expect 3 'CV6021: .*none/compile_programs' cost mobile --compilers none
expect 3 'mobile_compilers.sh' cost mobile --compilers none
expect 2 'a CONFIG is missing' cost
expect 2 'takes no CONFIG' cost mobile --check approved.json
expect 2 "'Mali-G0' is no GPU .*|Mali-G57" cost mobile --gpu Mali-G0
expect 1 'CV7009: .*not_there.json' cost --check not_there.json
echo '{}' >empty.json
expect 1 'CV7009: .*empty.json.* holds no costs' cost --check empty.json

compilers=${CREVICE_MOBILE_COMPILERS:-${XDG_CACHE_HOME:-$HOME/.cache}/crevice/mobile_compilers}
if [[ ! -e $compilers/compile_programs ]]; then
    finish || exit 1
    echo "SKIPPED: no compilers in $compilers; tools/scripts/mobile_compilers.sh builds them"
    exit 77
fi

# Compilers that end before their work is done.
mkdir -p broken && cp -rs -- "$(realpath -- "$compilers")"/inst broken/
printf '#!/bin/sh\necho no device\nexit 1\n' >broken/compile_programs && chmod +x broken/compile_programs
expect 3 "CV6021: the compiler for Mali-G52 in 'broken' does not work: no device" cost mobile --compilers broken

cp -r -- "$source/effects" "$source/configs" .
cost=(cost learnopengl --effects . --scene spheres --size 96x54)
expect 0 '^ssao  *0\.[78]' "${cost[@]}"  # the background is masked
for gpu in Mali-G52 Mali-G57 Mali-T860 Adreno-630 V3D-4.2; do
    check "the table has $gpu" grep -q -- "| $gpu" stdout.txt
done
check "the table ends with where to read on" grep -q 'docs/reference/cost.md' <(tail -n 1 stdout.txt)
expect 0 '"arithmetic_16_bit"' "${cost[@]}" --json --gpu Adreno-630
expect_json
expect 0 '' "${cost[@]}" --out approved.json
expect 0 '^0 figures worse, 0 better' cost --check approved.json --effects .
sed -i 's/"samples": 64/"samples": 32/' configs/ports/learnopengl.json
expect 0 'better: learnopengl, Adreno-630: instructions run a pixel' cost --check approved.json --effects .
sed -i 's/"samples": 32/"samples": 64/' configs/ports/learnopengl.json

# A loop across which more values live than a thread has registers, but on Adreno, which then runs fewer threads; and an
# array that a variable indexes, which Mali-T860 takes for spills.
cp effects/filter/shaders/box.frag box.frag
# plant LINE...: puts the lines before the last of the shader's.
plant() { { sed '$d' box.frag; printf '%s\n' "$@" '}'; } >effects/filter/shaders/box.frag; }
live=('highp float total = 0.0;')
for ((i = 0; i < 96; ++i)); do live+=("highp float live$i = sin(uv.x * $i.5);"); done
live+=('for (int i = 0; i < int(gl_FragCoord.y); ++i) {')
for ((i = 0; i < 96; ++i)); do live+=("total = fract(total * live$i + 0.5);"); done
plant "${live[@]}" '}' 'ao_filtered += total;'
expect 5 'worse: learnopengl, Mali-G57: spills were 0' cost --check approved.json --effects .
for gpu in Mali-G52 Mali-G57 Mali-T860 Adreno-630 V3D-4.2; do
    [[ $gpu == Adreno-630 ]] ||
        check "it spills on $gpu" grep -q -- "$gpu: spills were 0" stdout.txt
    check "it takes more instructions on $gpu" grep -q -- "worse: learnopengl, $gpu: instructions were" stdout.txt
done
check "it halves the threads" grep -q 'Mali-G57: occupancy was 2 and is 1 of 2' stdout.txt
check "it costs Adreno threads" grep -q 'Adreno-630: occupancy was [0-9]* and is' stdout.txt
plant 'highp float kept[96];' 'for (int i = 0; i < 96; ++i) kept[i] = sin(float(i) * uv.x);' \
    'for (int i = 0; i < 96; ++i) ao_filtered += kept[int(gl_FragCoord.x * float(i)) % 96];'
expect 5 'worse: learnopengl, Mali-T860: spills were 0' cost --check approved.json --effects .

# Twice the fetches.
sed 's/texture(ao, \(.*\))\.r/0.5 * (texture(ao, \1).r + texture(ao, \1 + texel).r)/' box.frag \
    >effects/filter/shaders/box.frag
check "the fetch is doubled" grep -q '+ texel).r)' effects/filter/shaders/box.frag
expect 5 'worse: learnopengl: fetches a pixel were' cost --check approved.json --effects .

# What no compiler takes.
sed 's/^void main()/float broken() { return nothing; }\nvoid main()/' box.frag >effects/filter/shaders/box.frag
expect 5 "a pass is refused" cost --check approved.json --effects .
check "a sum without a refused pass is no gain" bash -c '! grep -q better: stdout.txt'
finish
