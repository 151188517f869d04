#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The JSON Schema of configs: the generated files are current, and a validator that is not ours takes every
# shipped file and refuses what is wrong. Exit code 77 (skipped) where python3-jsonschema is missing, 1 with
# CREVICE_REQUIRE_JSONSCHEMA set.
#   schema_test.sh CREVICE SOURCE
set -euo pipefail
crevice=$1
source=$2
CREVICE=$crevice "$source/tools/scripts/schema.sh" --check
if ! python3 -c 'import jsonschema' 2>/dev/null; then
    echo "SKIPPED: no validator; apt-get install python3-jsonschema"
    [[ -n ${CREVICE_REQUIRE_JSONSCHEMA:-} ]] && exit 1 || exit 77
fi
python3 "$(dirname -- "${BASH_SOURCE[0]}")/schema_check.py" "$source"
