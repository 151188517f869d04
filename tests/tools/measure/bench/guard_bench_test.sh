#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# guard_bench.sh passes where figures are the same, and fails where one got worse: a bench with planted results.
#   guard_bench_test.sh CREVICE GUARD_BENCH
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
real=$1 script=$2
source "$here/../../../support/cli_checks.sh"
source "$here/../../../support/bench_results.sh"

mkdir -p tools/scripts docs/bench
cp -- "$script" "$(dirname -- "$script")/built_crevice.sh" tools/scripts/
printf '#!/bin/sh\n[ "$1" = bench ] || exec "%s" "$@"\nfor out; do :; done\ncp "%s" "$out/results.jsonl"\n' \
    "$real" "$work/fresh.jsonl" >crevice
chmod +x crevice
export CREVICE=$work/crevice
crevice=tools/scripts/guard_bench.sh

bench_sample a4 fine 4 1.0 0.05 >docs/bench/results.jsonl
cp docs/bench/results.jsonl fresh.jsonl
expect 0 '0 figures worse'
sed -i 's/"rmse":0.05,/"rmse":0.06,/' fresh.jsonl
expect 1 'worse: fine samples=4, room, 960x540: rmse was 0.05'
finish
