#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# EGL and OSMesa draw the same picture of every config: at most one pixel in a thousand is off by more than 2/255.
#   backends_agree_test.sh CREVICE
set -euo pipefail
here=$(realpath -- "$(dirname -- "${BASH_SOURCE[0]}")")
source "$here/../support/cli_checks.sh"
source "$here/old_gl.sh"

got=0
"$crevice" test "$here/backends_agree.json" --require-backends >stdout.txt 2>stderr.txt || got=$?
if grep -q 'CV600[12]' stdout.txt && [[ -z ${CREVICE_REQUIRE_GL:-} ]]; then
    sed 's/^/SKIPPED: /' stdout.txt
    exit 77
fi
check "both draw the same: $(cat stdout.txt)" test "$got" -eq 0
# Desktop OpenGL 3.3 with nothing beyond draws the same too.
echo '{"format": 1, "configs": ["learnopengl", "mobile", "balanced"], "scenes": ["room"], "sizes": ["160x90"],
    "backends": ["osmesa"], "approved_format": "pfm", "checks": [{"approved": {"max": 0.00785, "share": 0.001}}]}' >old.json
expect 0 '3 new' test old.json --approve
env "${gl33[@]}" "$crevice" test old.json --require-backends >stdout.txt 2>&1 || got=$?
check "OpenGL 3.3 draws the same: $(cat stdout.txt)" test "$got" -eq 0
finish
