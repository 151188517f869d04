#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Plants single faults in shaders, one at a time, and demands that `crevice stress --quick` finds them: a case fails that
# does not without the fault. mutations.txt has the faults.
#   mutations_test.sh CREVICE CHECKOUT [FAULT]    FAULT: only those whose name contains it
set -euo pipefail
crevice=$1
checkout=$2
only=${3:-}
least=27  # docs/stress.md lists those that are not found
table=$checkout/tests/tools/stress/mutations.txt
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

got=0
"$crevice" stress gtao --quick --case no_op --out "$work/probe" >"$work/log" 2>&1 || got=$?
if ((got == 3)) && [[ -z ${CREVICE_REQUIRE_GL:-} ]]; then
    sed 's/^/SKIPPED: /' "$work/log"
    exit 77
fi

# failing CONFIG FOLDER: the cases that fail, a line each, with why.
failing() {
    "$crevice" stress "$1" --quick --size 128x72 --effects "$2" --out "$2/stress" >"$2/stdout" 2>"$2/stderr" || true
    grep -E '^  [a-z_]+ .*(breaks at|VOID)' "$2/stdout" || grep -m1 'error' "$2/stderr" | sed 's/^/  error /' || true
}
fresh() {
    rm -rf -- "${work:?}/tree"
    mkdir "$work/tree"
    cp -r -- "$checkout/effects" "$checkout/configs" "$work/tree"
}

declare -A ordinary
faults=0 found=0 named=0
while IFS='|' read -r config pass file expression fault; do
    config=${config// /} pass=${pass// /} file=${file// /} fault=${fault# }
    expression=$(sed 's/^ *//; s/ *$//' <<<"$expression")
    [[ $config == \#* || $fault != *"$only"* ]] && continue
    if [[ -z ${ordinary[$config]:-} ]]; then
        fresh
        ordinary[$config]=" $(failing "$config" "$work/tree" | awk '{ print $1 }' | tr '\n' ' ') "
    fi
    fresh
    sed -i "$expression" "$work/tree/effects/$file"
    if cmp -s "$work/tree/effects/$file" "$checkout/effects/$file"; then
        echo "FAILED: '$fault' changes nothing in $file"
        exit 1
    fi
    faults=$((faults + 1))
    new=$(failing "$config" "$work/tree" | while read -r case why; do
        [[ ${ordinary[$config]} == *" $case "* && $why != *"pass '"* ]] || echo "$case: $why"
    done)
    if [[ -z $new ]]; then
        echo "not found: $config, $fault"
        continue
    fi
    found=$((found + 1))
    if grep -q "pass '$pass'" <<<"$new"; then named=$((named + 1)); fi
    echo "found: $config, $fault: $(wc -l <<<"$new") cases, ${new%%$'\n'*}"
done <"$table"
echo "$faults faults, $found found, $named with the pass named"
[[ -n $only ]] || ((found >= least))
