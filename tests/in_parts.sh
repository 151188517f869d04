#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs one of several parts of a Catch2 program's tests: a process a part, not a test.
#   in_parts.sh PROGRAM PART PARTS [CATCH2 ARGUMENT...]    PART from 0; the arguments choose tests
set -euo pipefail
program=$1
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
count() { "$program" --input-file "$work/part" --list-test-names-only | wc -l; }

"$program" "${@:4}" --list-test-names-only >"$work/all" || true  # whose exit code is their number
# Unescaped, commas and brackets of a name are Catch2's own.
awk -v part="$2" -v parts="$3" 'NR % parts == part' "$work/all" | sed 's/[][,\\"]/\\&/g' >"$work/part"
if (($(count || true) != $(wc -l <"$work/part") || $(wc -l <"$work/part") == 0)); then
    echo "FAILED: part $2 of $3 is not what it should be" >&2
    exit 1
fi
"$program" --input-file "$work/part" | { grep -v '^Filters: ' || true; }  # of which Catch2 prints every name
