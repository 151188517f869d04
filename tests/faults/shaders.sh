#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Plants single faults in shaders, one at a time, and demands that `crevice stress --quick` finds them: a case fails that
# does not without the fault; and that more of them are worse than the run without a fault (`--against`). shaders.txt has
# the faults. The cases are the eight in which each fault that any finds fails; all with CREVICE_NIGHTLY set.
#   shaders.sh CREVICE CHECKOUT [FAULT]    FAULT: only those whose name contains it
set -euo pipefail
crevice=$1
checkout=$2
only=${3:-}
least=39 least_named=35 least_against=42  # docs/reference/stress.md lists those that are not found
table=$checkout/tests/faults/shaders.txt
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
    local against=() size=128x72 cases=()
    [[ -n ${CREVICE_NIGHTLY:-} ]] || cases=(--case units --case plane_near_far --case near_far --case plane_fov
        --case plane_grazing --case mirrored --case ambient_alone --case light_behind --case wall_walk)
    [[ ! -e $work/$1.before ]] || against=(--against "$work/$1.before")
    if [[ $1 == *_temporal ]]; then  # faults of the history alone, which other cases show no better
        size=256x144                 # below that `history` fails by noise alone
        cases=(--case history --case cut --case still --case plane_near_far --case lights)
    fi
    "$crevice" stress "$1" --quick --size $size ${cases[@]+"${cases[@]}"} --effects "$2" --out "$2/stress" \
        ${against[@]+"${against[@]}"} >"$2/stdout" 2>"$2/stderr" || true
    grep -E '^  [a-z_]+ .*(breaks at|VOID)' "$2/stdout" || grep -m1 'error' "$2/stderr" | sed 's/^/  error /' || true
}
# fresh FOLDER: effects and configs as they are.
fresh() {
    rm -rf -- "${1:?}"
    mkdir "$1"
    cp -r -- "$checkout/effects" "$checkout/configs" "$1"
}

# try NUMBER CONFIG PASS FILE EXPRESSION FAULT: what came of it, as a line of $work/NUMBER.found.
try() {
    local tree=$work/$1 new
    fresh "$tree"
    sed -i "$5" "$tree/effects/$4"
    if cmp -s "$tree/effects/$4" "$checkout/effects/$4"; then
        echo "FAILED: '$6' changes nothing in $4" >"$tree.found"
        return
    fi
    new=$(failing "$2" "$tree" | while read -r case why; do
        [[ $(<"$work/$2.ordinary") == *" $case "* && $why != *"' writes "* ]] || echo "$case: $why"
    done)
    grep -oE '^[0-9]+ steps are worse' "$tree/stdout" >"$tree.differ" || true
    rm -rf -- "${tree:?}"
    if [[ -z $new ]]; then
        echo "not found: $2, $6; $(<"$tree.differ")" >"$tree.found"
    elif grep -q "pass '$3'" <<<"$new"; then
        echo "found, pass named: $2, $6: $(wc -l <<<"$new") cases, $(grep -m1 "pass '$3'" <<<"$new")" >"$tree.found"
    else
        echo "found: $2, $6: $(wc -l <<<"$new") cases, ${new%%$'\n'*}" >"$tree.found"
    fi
}

faults=0
while IFS='|' read -r config pass file expression fault; do
    config=${config// /} pass=${pass// /} file=${file// /} fault=${fault# }
    expression=$(sed 's/^ *//; s/ *$//' <<<"$expression")
    [[ $config == \#* || $fault != *"$only"* ]] && continue
    if [[ ! -e $work/$config.ordinary ]]; then
        wait
        fresh "$work/tree"
        echo " $(failing "$config" "$work/tree" | awk '{ print $1 }' | tr '\n' ' ') " >"$work/$config.ordinary"
        mv -- "$work/tree/stress" "$work/$config.before"
    fi
    faults=$((faults + 1))
    while (($(jobs -rp | wc -l) >= $(nproc))); do wait -n; done
    try "$(printf %03d $faults)" "$config" "$pass" "$file" "$expression" "$fault" &
done <"$table"
wait
cat "$work"/*.found
found=$(cat "$work"/*.found | grep -c '^found') || true
named=$(cat "$work"/*.found | grep -c '^found, pass named') || true
against=$(cat "$work"/*.differ | grep -c '^[1-9]') || true
echo "$faults faults, $found found, $named with the pass named; $against worse than the run before"
if grep -q '^FAILED' "$work"/*.found; then exit 1; fi
[[ -n $only ]] || ((found >= least && named >= least_named && against >= least_against))
