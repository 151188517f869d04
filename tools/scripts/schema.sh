#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes what is generated from the table of the config format (core/config/fields.h): docs/config.schema.json for
# editors, and the tables in configs/README.md behind the line that names the command; and what is read of scene files,
# in docs/reference/scene_files.md.
#
#   tools/scripts/schema.sh          writes them
#   tools/scripts/schema.sh --check  changes nothing; exit code 1 where one of them is not current
#
# CREVICE may name a built command; otherwise the release preset is built.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

schema=docs/config.schema.json
tables=configs/README.md
scenes=docs/reference/scene_files.md
case ${1:-} in
    "") check=false ;;
    --check) check=true ;;
    *) echo "usage: tools/scripts/schema.sh [--check]" >&2; exit 2 ;;
esac
source tools/scripts/built_crevice.sh

"$CREVICE" schema >"$work/schema"
# behind FORMAT FILE: the file up to the line that names the command, and what that prints.
behind() { sed "/^<!-- crevice schema --format $1 -->\$/q" "$2"; "$CREVICE" schema --format "$1"; }
behind markdown "$tables" >"$work/tables"
behind scenes "$scenes" >"$work/scenes"

current=true
# put NEW FILE
put() {
    if ! $check; then cp -- "$1" "$2"; return; fi
    diff --unified=0 "$2" "$1" && return
    current=false
    echo "$2 is not current: run tools/scripts/schema.sh and commit what it writes" >&2
}
put "$work/schema" "$schema"
put "$work/tables" "$tables"
put "$work/scenes" "$scenes"
$current
