#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A peer's shader, from three.js's GLSL to a sample of a bench. Exit code 77 (skipped) where there is no node.
#   peers_test.sh CREVICE TOOLS_PEERS
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
tools=$2
command -v node >/dev/null || { echo "SKIPPED: no node; apt-get install nodejs"; exit 77; }
source "$here/../../../support/cli_checks.sh"

mkdir peers
node "$here/made_up.mjs" "$tools" peers
expect 0 'ok' validate peers/made_up.json
expect 0 'wrote ao.pfm' render peers/made_up.json --scene plane --size 32x18 --out ao=ao.pfm
# strength 0.5 times 0.5, and the offset 0.125, halved, and a quarter of the noise's 128 of 255
check "uniforms, arrays, chunks and noise have the library's values" node -e '
    const bytes = require("fs").readFileSync("ao.pfm");
    const value = bytes.readFloatLE(bytes.length - 4);
    process.exit(Math.abs(value - (0.5 * 0.375 + 0.25 * 128 / 255)) < 1e-6 ? 0 : 1)'

expect 0 '2 measured' bench --config hemisphere_box --config peers/made_up.json --scene spheres --size 32x18 --rays 4 \
    --repeats 1 --no-cache --out bench

finish
