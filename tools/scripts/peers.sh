#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes configs of other libraries' own shaders, to be measured beside ours on the same depth and normals: n8ao in all of
# its modes, learned denoisers too, full and half resolution, three.js's GTAO, SSAO and SAO passes, and postprocessing's
# SSAOEffect. Their texts come from npm, are translated to GLSL ES 3.00 and stay in FOLDER: none of them is part of this
# project, each has its own licence.
#
#   tools/scripts/peers.sh [FOLDER]     default: peers/ in the cache of crevice, ~/.cache/crevice/peers
#   crevice bench --config FOLDER/NAME.json    measures one of them
#
# Needs node 20 and npm. What npm fetches is kept in FOLDER/npm.
set -euo pipefail
packages=(n8ao@2.1.0 three@0.187.0 postprocessing@6.39.6)

if (($# > 1)) || [[ ${1:-} == -* ]]; then
    echo "usage: tools/scripts/peers.sh [FOLDER]" >&2
    exit 2
fi
folder=${1:-${XDG_CACHE_HOME:-$HOME/.cache}/crevice/peers}
for tool in node npm; do
    command -v "$tool" >/dev/null || { echo "$tool is missing: install Node.js 20 or later" >&2; exit 1; }
done
mkdir -p -- "$folder/npm"
if [[ "$(cat -- "$folder/npm/packages" 2>/dev/null)" != "${packages[*]}" ]]; then
    npm install --prefix "$folder/npm" --ignore-scripts --no-audit --no-fund --silent "${packages[@]}"
    echo "${packages[*]}" >"$folder/npm/packages"
fi
node "$(dirname -- "${BASH_SOURCE[0]}")/../measure/peers/make.mjs" "$folder/npm/node_modules" "$folder"
