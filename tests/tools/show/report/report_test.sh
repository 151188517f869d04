#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# crevice report, choose and compare-bench, as a user's shell sees them.
#   report_test.sh CREVICE
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../../support/cli_checks.sh"
source "$here/../../../support/bench_results.sh"
write_results

for command in report choose compare-bench; do
    expect 0 'Example' "$command" --help
    expect 1 'CV7009' "$command" results.jsonl nothing.jsonl $([[ $command != choose ]] || echo --error 1)
done

# --- report ---
expect 0 'wrote report.html \(6 bench samples' report results.jsonl
check "there is a CSV with every bench sample" test "$(wc -l <report.csv)" -eq 7
cp report.json stdout.txt
expect_json
expect 0 'wrote a.html' report results.jsonl --out a.html --no-pictures
check "--no-pictures leaves the pictures out" bash -c '! grep -q "data:image" a.html'
expect 2 'CV8001.*html' report results.jsonl --out a.txt
expect 4 'CV7007' report results.jsonl --out nowhere/a.html
mkdir sharded
cp results.jsonl sharded/
expect 0 'CV7005.*a4.png|wrote report.html' report sharded/results.jsonl

# --- a part of a bench ---
mkdir part
{
    printf '{"planned":{"device":"device A","command":"c","bench_samples":["1","2","3"]}}\n'
    cat results.jsonl
} >part/results.jsonl
expect 0 '5 of 9 bench samples measured, 1 failed: quick, fine, <b>slow</b>; what to take may change' report part --out part.html
check "the page says so" grep -q '"text":"5 of 9 bench samples measured' part.html
check "and the JSON" grep -q '"planned": 9' part.json
expect 0 '5 of 9 bench samples measured' choose part --budget 3ms
expect 0 '"planned": 9' choose part --budget 3ms --json
expect_json
check "a whole bench is no part" bash -c '! grep -q "bench samples measured" <(crevice=$1; "$crevice" report results.jsonl)' _ "$crevice"

# --- choose ---
expect 0 '^fine samples=4$' choose results.jsonl --budget 3ms
expect 0 'why: of 5 configs, 3 have at most 3 ms; this one has the lowest error' choose results.jsonl --budget 3ms
expect 0 '^quick samples=16$' choose results.jsonl --error 0.09
expect 0 '^quick samples=4$' choose results.jsonl --budget 1.5x
expect 0 'crevice render fine --set samples=16 --scene room' choose results.jsonl --error 0.045
expect 0 '"config": "fine"' choose results.jsonl --budget 3000us --json
expect_json
expect 1 'CV4001.*none of 5' choose results.jsonl --budget 0.1ms
expect 1 'nearest is quick samples=4' choose results.jsonl --budget 0.1ms
expect 2 'CV8001' choose results.jsonl
expect 2 'CV8001' choose results.jsonl --budget 2ms --error 0.1
expect 2 'CV8001' choose results.jsonl --budget soon
expect 2 'CV8001.*cellar' choose results.jsonl --budget 2ms --scene cellar
expect 1 'CV4005' choose results.jsonl --budget 2ms --size 3

# --- compare-bench ---
expect 0 '5 bench samples compared: 0 figures worse' compare-bench results.jsonl results.jsonl
sed 's/"rmse":0.05,/"rmse":0.06,/' results.jsonl >worse.jsonl
expect 5 'worse: fine samples=4, room, 960x540: rmse was 0.05 and is 0.06' compare-bench results.jsonl worse.jsonl
expect 5 'better, which may be a fault: fine samples=4, room, 960x540: rmse was 0.06 and is 0.05' compare-bench worse.jsonl results.jsonl
expect 0 '0 figures worse' compare-bench results.jsonl worse.jsonl --max-error 0.02
sed 's/"ratio_copy":6.0/"ratio_copy":7.0/' results.jsonl >slower.jsonl
expect 5 'ratio_copy was 6 and is 7' compare-bench results.jsonl slower.jsonl
expect 0 '0 figures worse' compare-bench results.jsonl slower.jsonl --max-ratio 0.2
expect 0 'better: .*ratio_copy was 7 and is 6' compare-bench slower.jsonl results.jsonl
sed 's/"room"/"hall"/' results.jsonl >other.jsonl
expect 1 'CV7009.*no bench sample is in both' compare-bench results.jsonl other.jsonl
finish
