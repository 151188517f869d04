#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the libraries and the page of tools/examples/web with Emscripten, into build/web/tools/examples/web.
#   web.sh [ARGUMENT...]    further arguments of cmake
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
command -v em++ >/dev/null || { echo "web.sh: no em++; apt-get install emscripten" >&2; exit 1; }
export NODE_PATH=/usr/share/nodejs  # of Debian's node-acorn, for a Node.js that is not Debian's
source tools/scripts/built_crevice.sh  # which bakes what the page draws
cmake -G Ninja -S . -B build/web -DCREVICE_COMMAND="$(realpath -- "$CREVICE")" --toolchain tools/cmake/web.cmake -DCMAKE_BUILD_TYPE=MinSizeRel \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=10 \
    -DCREVICE_TOOLS=OFF -DCREVICE_TESTS=OFF -DCREVICE_INSTALL=OFF -DCREVICE_WERROR=ON "$@"
cmake --build build/web
echo "Wrote build/web/tools/examples/web; show it with: python3 -m http.server -d build/web/tools/examples/web"
