#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# crevice bench where something goes wrong: broken scenes and configs, an interrupt, a kill, a full disk. Whatever
# happened, the errors at the end are those of a run that nothing disturbed.
#   bench_stop_test.sh CREVICE
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/../../../support/cli_checks.sh"

tiny=(--size 64x36 --rays 4 --cache cache)
small=("${tiny[@]}" --repeats 2)
probe "$crevice" bench --config learnopengl --scene plane "${small[@]}" --out probe
check "a bench of one sample succeeds" test "$got" -eq 0

# figures FOLDER: what a second run must find again: keys and errors, without times.
figures() {
    sed -nE 's/.*"error":(\{[^}]*\}).*"key":"([0-9a-f]*)".*/\2 \1/p' "$1/results.jsonl" | sort
}
same_figures() { diff <(figures "$1") <(figures "$2"); }

# --- what is unusable fails, the rest is measured ---
printf 'void main() { nonsense; }\n' >broken.frag
cat >broken.json <<'JSON'
{
  "format": 1, "name": "broken", "extends": ["geometry/position_normal", "ssao/hemisphere"],
  "shaders": { "ssao": { "fragment": "./broken.frag" } }
}
JSON
expect 1 'failed: learnopengl, nowhere.glb, 64x36: CV7001' bench --config learnopengl \
    --config broken.json --scene nowhere.glb --scene corner "${small[@]}" --out mixed
check "the good sample was measured" grep -q '1 measured, .* 3 failed' stderr.txt
check "the shader's place is reported" grep -q 'failed: broken.json, corner.*broken.frag:1:.*CV50' stderr.txt
expect 1 'CV7008: the camera sees no surface' bench --config learnopengl --scene corner \
    --camera 'eye=0,5,0;at=0,50,1' "${small[@]}" --out away

# --- a mean over frames does not depend on how many were timed ---
for turns in 1 3; do
    expect 0 '1 measured' bench --config gtao_temporal --scene corner "${tiny[@]}" --repeats "$turns" \
        --out "frames$turns"
done
check "more turns change no error" same_figures frames1 frames3

# --- stopped and gone on ---
runs=(--config learnopengl --config thesis --scene corner --samples 4,8,16 "${small[@]}")
expect 0 '6 measured' bench "${runs[@]}" --out whole

stop INT interrupted/results.jsonl bench "${runs[@]}" --out interrupted
check "an interrupt ends with 130" test "$got" -eq 130
check "what is missing is reported" grep -q '^missing: thesis samples=16' stderr.txt
expect 0 '0 failed, 0 not begun' bench "${runs[@]}" --out interrupted
check "nothing is measured twice" test "$(wc -l <interrupted/results.jsonl)" -eq 6
check "an interrupt changes no figure" same_figures whole interrupted

stop KILL killed/results.jsonl bench "${runs[@]}" --out killed
printf '{"ao_picture":"pictures/torn' >>killed/results.jsonl
expect 0 '0 failed, 0 not begun' bench "${runs[@]}" --out killed
check "a kill and a torn line change no figure" same_figures whole killed

# A limit on the size of files stands in for a full disk, which takes a mount.
got=0
(ulimit -f 4 && "$crevice" bench "${runs[@]}" --out full) 2>stderr.txt || got=$?
check "a full disk ends with 4" test "$got" -eq 4
check "only whole lines are left" test "$(grep -c '}$' full/results.jsonl)" -eq "$(wc -l <full/results.jsonl)"
expect 0 '0 failed, 0 not begun' bench "${runs[@]}" --out full
check "a full disk changes no figure" same_figures whole full
finish
