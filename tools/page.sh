#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the page, static files for any web server or `crevice view`, into out/page: the engine with Emscripten, the rest
# with what npm brings. Prints how large it is.
#   page.sh [FOLDER]    another folder to put it into
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
folder=$(realpath -m -- "${1:-$root/out/page}")
cd -- "$root"
for tool in em++ node npm; do
    command -v "$tool" >/dev/null || { echo "page.sh: no $tool; apt-get install emscripten nodejs npm" >&2; exit 1; }
done
tools/scripts/web.sh >&2
npm=build/page_npm
if ! cmp -s tools/show/page/package-lock.json "$npm/installed.json"; then
    mkdir -p "$npm"
    cp tools/show/page/package.json tools/show/page/package-lock.json "$npm"
    npm ci --prefix "$npm" --ignore-scripts --no-audit --no-fund --silent
    cp tools/show/page/package-lock.json "$npm/installed.json"
fi
rm -rf -- "$folder"
mkdir -p -- "$folder"
node tools/show/page/build.mjs "$folder" "$root/$npm/node_modules"
cp build/web/tools/show/page/crevice_page.{js,wasm} "$folder"
bytes=$(find "$folder" -type f -exec gzip -9c {} + | wc -c)
printf 'Wrote %s, %d bytes with gzip -9; show it with: crevice view, or python3 -m http.server -d %s\n' "$folder" "$bytes" \
    "$folder"
