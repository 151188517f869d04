#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Regression guard: measures a small bench of all shipped configs and says which errors are not the
# figures in docs/bench, which cost ratios are worse, never by times. Exit code 1 where something is
# worse, fails or is missing, and where an error is better: a fault may happen to lower one.
#
#   tools/scripts/guard_bench.sh                on a quiet machine; about two minutes
#   tools/scripts/guard_bench.sh --errors-only  no cost ratios: for a busy machine, and quicker
#   tools/scripts/guard_bench.sh --update       takes what is measured now as docs/bench: look at git diff
#
# docs/bench/results.jsonl is what `crevice report docs/bench` shows; docs/bench/DEVICE/CONFIG.csv are
# the same figures to read. CREVICE may name a built command; otherwise the release preset is built.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

bench=(--size 320x180 --radius 1)
sweeps=("--scene room --scene spheres --samples 8,32" "--scene street --samples 16")
action=compare
case ${1:-} in
    "") ;;
    --errors-only) bench+=(--repeats 1) ;;
    --update) action=update ;;
    *) echo "usage: tools/scripts/guard_bench.sh [--errors-only | --update]" >&2; exit 2 ;;
esac

source tools/scripts/built_crevice.sh

# The comparison reports a bench sample that fails (1); new figures need all of them.
for sweep in "${sweeps[@]}"; do
    status=0
    # shellcheck disable=SC2086  # its words are options
    "$CREVICE" bench $sweep "${bench[@]}" --out "$work" || status=$?
    if ((status > 1)) || [[ $status$action == 1update ]]; then exit "$status"; fi
done

if [[ $action == compare ]]; then
    "$CREVICE" report "$work" --against docs/bench "$@" || {
        echo "If that is meant: tools/scripts/guard_bench.sh --update, and say why in the commit."
        exit 1
    }
    exit 0
fi

mkdir -p docs/bench
sed -E 's/"(ao|ground_truth|difference)_picture":"[^"]*"/"\1_picture":""/g' "$work/results.jsonl" \
    >docs/bench/results.jsonl
"$CREVICE" report docs/bench --out "$work/report.html"
device=$(sed -nE '1s/.*"device":"([^"]*)".*/\1/p' docs/bench/results.jsonl | tr -cs 'A-Za-z0-9.\n' '_')
rm -rf -- "docs/bench/$device"
mkdir "docs/bench/$device"
tr -d '\r' <"$work/report.csv" | awk -F, -v folder="docs/bench/$device" '
    NR == 1 { header = $0; next }
    { file = folder "/" $1 ".csv" }
    !(file in begun) { print header >file; begun[file] = 1 }
    { print >file }'
echo "wrote docs/bench/results.jsonl and docs/bench/$device/*.csv"
