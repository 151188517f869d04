#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/scripts/guard_bench.sh with a pretended bench: what it takes over, and what it calls worse.
#   guard_bench_test.sh CREVICE GUARD_BENCH
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
real=$1 script=$2
source "$here/../../support/cli_checks.sh"
source "$here/../../support/bench_results.sh"

# A tree of its own, and a crevice whose bench writes what `measure` was given.
mkdir -p tools/scripts
cp -- "$script" "$(dirname -- "$script")/built_crevice.sh" tools/scripts/
cat >crevice <<EOF
#!/usr/bin/env bash
[[ \$1 == bench ]] || exec "$real" "\$@"
echo "\$@" >"$work/bench.txt"
cp "$work/fresh.jsonl" "\${!#}/results.jsonl"
echo "bench ended with \$(cat "$work/code")"
exit \$(cat "$work/code")
EOF
chmod +x crevice
export CREVICE=$work/crevice
crevice=tools/scripts/guard_bench.sh

# measure CODE SED: the pretended bench ends with that code and has figures changed like that.
measure() {
    echo "$1" >code
    { bench_sample a4 quick 4 1.0 0.10; bench_sample a16 quick 16 2.0 0.09; bench_sample b4 fine 4 3.0 0.05; } |
        sed -E "$2" >fresh.jsonl
}

measure 1 ''
expect 1 "ended with 1" --update
check "a bench with failures is not taken over" test ! -e docs
measure 0 ''
expect 0 'wrote docs/bench/results.jsonl and docs/bench/device_A' --update
check "each config has its CSV" test "$(cat docs/bench/device_A/quick.csv | wc -l)" -eq 3
check "a CSV has one config" bash -c '! grep -q quick docs/bench/device_A/fine.csv'
check "no pictures are named" bash -c '! grep -q png docs/bench/results.jsonl'

expect 0 '3 bench samples compared: 0 figures worse'
cp bench.txt all.txt
measure 0 's/"key":"/&edited/; s/"median":[0-9.]+/"median":99/g'
expect 0 '0 figures worse'
measure 0 's/"rmse":0.05,/"rmse":0.06,/'
expect 1 'worse: fine samples=4, room, 960x540: rmse was 0.05'
expect 1 'guard_bench.sh --update'
measure 0 's/"rmse":0.05,/"rmse":0.04,/'
expect 1 'better, which may be a fault: fine samples=4, room, 960x540: rmse was 0.05 and is 0.04'
expect 1 'guard_bench.sh --update'
measure 0 's/"ratio_copy":3.0/"ratio_copy":2.0/'
expect 0 'better: fine samples=4, room, 960x540: ratio_copy'
measure 0 's/"ratio_copy":3.0/"ratio_copy":4.0/'
expect 1 'worse: fine samples=4, room, 960x540: ratio_copy'
expect 0 '0 figures worse' --errors-only
check "the samples are the same" grep -qF -- "$(sed 's/ --out.*//' all.txt)" bench.txt
measure 1 's/"key":"b4","failure":""/"key":"x","failure":"no memory"/'
expect 1 'fails now: fine samples=4, room, 960x540: no memory'
measure 0 '/fine/d'
expect 1 'missing now: fine samples=4, room, 960x540'
measure 4 ''
expect 4 "ended with 4"
expect 2 'usage' --quick
finish
