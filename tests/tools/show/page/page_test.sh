#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the page and uses it in headless Chromium over software WebGL, beside this machine's pictures. Prints how large
# the page is. Exit code 77 (skipped) where there is no Emscripten, Node.js or Chromium, 1 with CREVICE_REQUIRE_BROWSER
# set. With CREVICE_NIGHTLY set it turns every knob of every config and more, which takes five minutes.
#   page_test.sh CREVICE [ARGUMENT...]    the command; arguments of node, such as --test-name-pattern=typo
set -euo pipefail
kLargest=2097152  # bytes that the page may take, compressed
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../../.." && pwd)
CREVICE=$(realpath -- "$1")
BROWSER=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [[ -z $BROWSER ]] || ! command -v em++ >/dev/null || ! command -v npm >/dev/null; then
    echo "SKIPPED: no chromium, em++ or npm; apt-get install chromium emscripten npm"
    [[ -n ${CREVICE_REQUIRE_BROWSER:-} ]] && exit 1 || exit 77
fi
"$root/tools/page.sh"
PAGE=$root/out/page
bytes=$(find "$PAGE" -type f -exec gzip -9c {} + | wc -c)
((bytes <= kLargest)) || { echo "the page takes $bytes bytes, over $kLargest" >&2; exit 1; }
export CREVICE BROWSER PAGE
# Where node finds puppeteer-core.
mkdir -p "$root/build/page_test"
cp "$root"/tests/tools/show/page/*.mjs "$root/build/page_test"
ln -sfn "$root/build/page_npm/node_modules" "$root/build/page_test/node_modules"
node --test --test-reporter=spec "${@:2}" "$root/build/page_test/page_test.mjs"
