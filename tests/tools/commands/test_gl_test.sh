#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# crevice test as a user's shell sees it: approved pictures and plans, a constant of a shader that is changed, cells that are
# compared, processes side by side, an interrupt and what goes on after it.
#   test_gl_test.sh CREVICE
set -euo pipefail
checkout=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../.." && pwd)
source "$(dirname -- "${BASH_SOURCE[0]}")/../../support/cli_checks.sh"

cat >matrix.json <<'JSON'
{
  "format": 1, "configs": ["gtao", "learnopengl"], "scenes": ["corner", "spheres"], "sizes": ["96x64"],
  "checks": [
    {"approved": {"max": 0.02, "share": 0.001}}, {"plan": true, "where": {"scene": "corner"}}, {"finite": true},
    {"range": [0, 1]}, {"background": 1, "where": {"config": "gtao", "scene": "spheres"}}
  ]
}
JSON
probe "$crevice" test matrix.json --filter 'gtao, corner'
check "a missing approved file is a failure" test "$got" -eq 5
check "it names the way out" grep -q "gtao, corner: approved ao: there is no '.*': run with --approve" stdout.txt

# --- approved, held, and changed ---
expect 0 'new: gtao, corner: approved ao: approved/matrix/gtao-corner.ao.png' test matrix.json --approve
check "each cell has its picture" test "$(ls approved/matrix/*.png | wc -l)" -eq 4
expect 0 '^4 cells; checks: 6 unchanged' test matrix.json --approve
expect 0 '^4 cells; checks: 15 passed' test matrix.json
mkdir edited && cp -r -- "$checkout/effects" "$checkout/configs" edited
sed -i 's/bool inside = far < 1.0;/bool inside = far < 1.1;/' edited/effects/ssao/shaders/gtao.glsl
expect 5 '^failed: gtao, spheres: approved ao: [0-9.]+ % of pixels are off by more than 0.02' test matrix.json \
    --effects edited --out changed
check "no other config fails" bash -c '! grep -q "failed: learnopengl" stdout.txt'
check "the page names the cell and has its pictures" bash -c 'grep -q "\"difference\":\"pictures/gtao-spheres" changed/index.html'
check "there is its picture" test -s changed/pictures/gtao-spheres.ao.1.difference.png
expect 0 'changed: gtao, spheres: approved ao: ' test matrix.json --effects edited --approve --filter gtao --out before_after
check "the page of before and after has both" test -s before_after/pictures/gtao-spheres.ao.1.wanted.png
expect 0 'changed: gtao, spheres' test matrix.json --approve
touch approved/matrix/gone.ao.png
expect 0 "CV2108: no cell has these approved files: gone.ao.png" test matrix.json
rm approved/matrix/gone.ao.png
sed -i 's/32f/16f/' approved/matrix/gtao-corner.plan.txt; echo edited >>approved/matrix/gtao-corner.plan.txt
expect 5 "gtao, corner: plan: line [0-9]+ is '" test matrix.json
"$crevice" test matrix.json --approve >/dev/null

# --- processes, shards, and what is known already ---
expect 5 '' test matrix.json --effects edited --jobs 2 --out two
expect 5 '' test matrix.json --effects edited --out one
check "results do not depend on the number of processes" cmp one/results.json two/results.json
expect 0 '^2 cells; ' test matrix.json --shard 2/2 --out shard
expect 2 'CV8001.*--shard' test matrix.json --shard 3/2
expect 2 'CV8001.*no cell' test matrix.json --filter gtoa
expect 5 '3 cells known already' test matrix.json --effects edited --out two --resume
check "they are in the results too" cmp one/results.json two/results.json
expect 0 '"passed": 15' test matrix.json --json
expect_json

# --- cells that are compared, truth, time, floats ---
cat >compared.json <<'JSON'
{
  "format": 1, "configs": ["gtao", "learnopengl"], "scenes": ["corner", "plane"], "sizes": ["96x64"],
  "params": {"intensity": [1, 0]}, "approved_format": "pfm", "approved_folder": "floats",
  "checks": [
    {"same": {"as": {"config": "learnopengl"}}, "where": {"intensity": 0}},
    {"same": {"as": {"config": "learnopengl"}, "max": 0.01}, "where": {"intensity": 1, "scene": "corner"}},
    {"truth": {"rmse": 0.2, "bias": 0.2, "rays": 16}, "where": {"config": "gtao", "scene": "corner", "intensity": 1}},
    {"truth": {"rmse": 0.01, "rays": 16}, "where": {"config": "gtao", "scene": "corner", "intensity": 0}},
    {"open": {"least": 0.99, "rays": 16}, "where": {"config": "gtao", "scene": "plane", "intensity": 1}},
    {"approved": {"flip": 0}, "where": {"config": "gtao"}},
    {"time": {"over": {"intensity": 1}, "most": 1e-9}, "where": {"config": "gtao", "scene": "corner"}},
    {"finite": true, "output": "target.ao", "where": {"config": "learnopengl", "intensity": 1}},
    {"finite": true, "where": {"config": "learnopengl"}}
  ]
}
JSON
expect 0 '4 new' test compared.json --approve --no-cache
expect 5 '' test compared.json --no-cache --jobs 2
check "what differs fails" grep -q "^failed: gtao, corner, intensity=1: same ao: as 'learnopengl, corner, intensity=1': " stdout.txt
check "truth is missed without AO" grep -q '^failed: gtao, corner, intensity=0: truth ao: rmse is' stdout.txt
check "a time is held against its limit" grep -q '^failed: gtao, corner, intensity=0: time ao: takes' stdout.txt
check "nothing else fails" test "$(grep -c '^failed' stdout.txt)" -eq 3

# --- each property can fail, of a config that writes NaN where its occlusion is not 1 ---
cat >nan.frag <<'GLSL'
#version 300 es
precision highp float;
uniform highp sampler2D ao;
in vec2 uv;
layout(location = 0) out float ao_filtered;
void main() { ao_filtered = sqrt(texture(ao, uv).r - 1.0) + 0.5; }
GLSL
echo '{"format": 1, "name": "nan", "description": "Writes NaN.", "extends": ["geometry/depth_normal", "ssao/gtao"],
  "targets": {"ao_filtered": {"format": ["r32f", "r16f"]}},
  "shaders": {"spoil": {"vertex": "common/fullscreen.vert", "fragment": "./nan.frag"}}, "outputs": {"ao": "ao_filtered"},
  "passes": {"spoil": {"type": "fullscreen", "shader": "spoil", "color": ["ao_filtered"]}}}' >nan.json
echo '{"format": 1, "configs": ["nan.json"], "scenes": ["spheres"], "sizes": ["96x64"], "checks": [{"finite": true},
    {"range": [0, 1]}, {"background": 1}, {"open": {"least": 0.6, "rays": 16}}, {"approved": {"max": 1, "share": 1}}]}' >nan_matrix.json
"$crevice" test nan_matrix.json --approve >/dev/null 2>&1
expect 5 '^1 cell; checks: 5 failed' test nan_matrix.json --no-cache

# --- mistakes in the file end before anything is drawn ---
sed 's/"where"/"were"/; s/"gtao"/"gtoa"/' compared.json >wrong.json
expect 1 "wrong.json:[0-9]+:[0-9]+: error CV3001: 'were' is no key of a check" test wrong.json --out never
check "nothing was drawn" test ! -e never

# --- a backend that is not there ---
sed 's/"sizes"/"approved_folder": "approved\/matrix", "backends": ["egl", "osmesa"], "sizes"/' matrix.json >both.json
__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null expect 0 'checks: 15 passed, 15 skipped' test both.json
check "a skip says why" grep -q '# SKIP CV6001' crevice_test/results.tap
__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null expect 5 'failed: gtao, corner, egl: .*CV6001' test both.json --require-backends
__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null expect 3 'skipped' test matrix.json

# --- an interrupt, and what goes on after it ---
sed 's/"sizes"/"params": {"radius": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8]}, "sizes"/; s/{"approved.*/{"finite": true},/' \
    matrix.json | sed '/"plan"/d' >long.json
for jobs in 1 2; do
    stop INT "stopped$jobs/cells.jsonl" test long.json --out "stopped$jobs" --jobs "$jobs"
    check "an interrupt ends with 130 ($jobs)" test "$got" -eq 130
    expect 0 'cells? known already' test long.json --out "stopped$jobs" --jobs "$jobs" --resume
done
expect 0 '^32 cells' test long.json --out whole
check "an interrupt changes no result" cmp whole/results.json stopped2/results.json
finish
