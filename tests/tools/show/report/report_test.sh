#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# crevice report and choose, as a user's shell sees them.
#   report_test.sh CREVICE
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../../support/cli_checks.sh"
source "$here/../../../support/bench_results.sh"
write_results

for command in report choose; do
    expect 0 'Example' "$command" --help
    expect 1 'CV7009' "$command" results.jsonl nothing.jsonl $([[ $command != choose ]] || echo --error 1)
done

# --- report ---
expect 0 'wrote report.html \(6 bench samples' report results.jsonl
check "there is a CSV with every bench sample" test "$(wc -l <report.csv)" -eq 7
check "the page asks nothing of a network" bash -c \
    '! sed "s#http://www.w3.org/2000/svg##g" report.html | grep -qE "https?://|src=\"/|@import|/\*report\."'
expect 0 'wrote a.html' report results.jsonl --out a.html --no-pictures
check "--no-pictures leaves the pictures out" bash -c '! grep -q "data:image" a.html'
expect 2 'CV8001.*html' report results.jsonl --out a.txt
expect 4 'CV7007' report results.jsonl --out nowhere/a.html

# --- choose ---
expect 0 '^fine samples=4$' choose results.jsonl --budget 3ms
expect 0 'why: of 5 measured configs, 3 have at most 3 ms; this one is the fastest of those whose error is within 5 %' choose results.jsonl --budget 3ms
expect 0 'render fine --set samples=16 --scene room --size 960x540 --out ao=ao.png --frames 32' choose results.jsonl --error 0.045
expect 0 '"config": "fine"' choose results.jsonl --budget 3000us --json
expect_json
expect 1 'fastest is quick samples=4' choose results.jsonl --budget 0.1ms
expect 2 'CV8001.*--budget, --error or both' choose results.jsonl
expect 0 '^quick samples=16$' choose results.jsonl --budget 3ms --error 0.09
expect 2 'crevice choose --scene model.glb' choose --budget 2ms
sed 's/"room"/"hall"/' results.jsonl | cat results.jsonl - >halls.jsonl
expect 1 'name one, as in --scene (hall|room): ' choose halls.jsonl --budget 0.1ms
printf '\211PNG no results' >a.png
expect 1 "CV7009.*a.png.*none of its lines" choose a.png --error 1
expect 2 'RESULTS excludes --camera' choose results.jsonl --budget 2ms --camera top
expect 2 'samples=4, room.* no flicker for --motion' choose results.jsonl --budget 3ms --motion
grep b4 results.jsonl >moved.jsonl
expect 0 'includes a flicker of 0.0087' choose moved.jsonl --budget 3ms --motion
expect 2 "config 'mine.txt' does not end in .json" choose results.jsonl --budget 3ms --write mine.txt
expect 2 'no .json and no .h' choose results.jsonl --write-front mine.txt
sed '/slow/d; s/"config":"quick","overrides":\[/&"filter\/box=filter\/temporal",/; s/"\(quick\|fine\)"/"hemisphere_box"/' results.jsonl >fronts.jsonl
expect 0 'left out of the front, whose levels take scene: .* takes scene, velocity' choose fronts.jsonl --write-front front.json
check "a front's levels take the same" bash -c 'grep -c samples= front.json | grep -qx 2 && ! grep -q temporal front.json'
expect 1 'CV4005' choose results.jsonl --budget 2ms --size 3

# --- against an older bench ---
expect 0 '^5 bench samples compared' report results.jsonl --against results.jsonl
sed 's/"rmse":0.05,/"rmse":0.06,/' results.jsonl >worse.jsonl
expect 5 'worse: fine samples=4, room, 960x540: rmse was 0.05 and is 0.06' report worse.jsonl --against results.jsonl
expect 5 'better, which may be a fault: fine .*: rmse was 0.06 and is 0.05' report results.jsonl --against worse.jsonl
sed 's/"ratio_learnopengl":6.0/"ratio_learnopengl":7.0/' results.jsonl >slower.jsonl
expect 5 'ratio_learnopengl was 6 and is 7' report slower.jsonl --against results.jsonl
expect 0 '^5 bench samples compared' report slower.jsonl --against results.jsonl --errors-only
expect 0 'better: .*ratio_learnopengl was 7 and is 6' report results.jsonl --against slower.jsonl
sed 's/"room"/"hall"/' results.jsonl >other.jsonl
expect 5 'missing now: fine samples=4, room' report other.jsonl --against results.jsonl
finish
