#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the page of tools/examples/web, draws `mobile` and `balanced` by it in headless Chromium, and compares them
# with this machine's pictures of the same scene and camera: 99 % of the pixels differ by at most 2/255. With its
# meshes in buffers of its own the page draws the same, and takes the time of a frame on the GPU. Prints the size of
# the page's WebAssembly. Exit code 77 (skipped) where there is no Emscripten or Chromium, 1 with
# CREVICE_REQUIRE_BROWSER set.
#   web_test.sh BUILD [CONFIG...]   this machine's build; other configs
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
picture=$(realpath -- "$1")/tests/platforms/crevice_picture
configs=("${@:2}")
((${#configs[@]})) || configs=(mobile balanced)
page=$(cd -- "$here/../.." && pwd)/build/web/tools/examples/web
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [[ -z $browser ]] || ! command -v em++ >/dev/null; then
    echo "SKIPPED: no chromium or no em++; apt-get install chromium emscripten"
    [[ -n ${CREVICE_REQUIRE_BROWSER:-} ]] && exit 1 || exit 77
fi
"$here/../../tools/scripts/web.sh" -DCREVICE_PLATFORM_TESTS=some "-DCREVICE_WEB_CONFIGS=$(IFS=';' && echo "${configs[*]}")"
source "$here/../support/cli_checks.sh"

width=320 height=180

# browse NAME PROGRAM CONFIG...: the pixels that the page draws with that program, into CONFIG.NAME
browse()
{
    local name=$1 program=$2 config
    sed "s/width=\"640\" height=\"360\"/width=\"$width\" height=\"$height\"/; s#src=\".*js\"#src=\"file://$program\"#" \
        "$page/index.html" >"$name.html"
    {
        printf '<script>\nconst configs = "%s".split(" ");\n' "${*:3}"
        cat "$here/web_probe.js"
        printf '</script>\n'
    } >>"$name.html"
    timeout 300 "$browser" --headless --no-sandbox --disable-gpu-sandbox --use-gl=angle \
        --use-angle=swiftshader --enable-unsafe-swiftshader --no-first-run --disable-quic \
        --disable-background-networking --disable-component-update --disable-sync --disable-extensions \
        --allow-file-access-from-files --user-data-dir="$work/profile" --virtual-time-budget=60000 \
        --enable-logging=stderr --dump-dom "file://$work/$name.html" >"$name.dom" 2>"$name.log" || cat "$name.log"
    for config in "${@:3}"; do
        sed -n "s/.*<pre id=\"pixels_$config\">//p" "$name.dom" | base64 --decode >"$config.$name"
    done
    # What WebGL refuses, or calls slow; that pictures are read back is the test's.
    grep 'CONSOLE.*WebGL' "$name.log" | grep -v 'GPU stall due to ReadPixels' >refused.txt || true
    check "WebGL has nothing to say to how the page draws, with $name" test ! -s refused.txt
    ((failures == 0)) || sed -n 's/.*<pre id="message">//p' "$name.dom" | cat refused.txt -
}

browse web "$page/crevice_web.js" "${configs[@]}"
for config in "${configs[@]}"; do
    "$picture" "$config" "$width" "$height" "$config.native"
    check "$config in the browser is within 2/255 of the native picture in 99 % of pixels" \
        /usr/bin/python3 "$here/compare.py" "$config.web" "$config.native" 2 99
done
browse buffers "${page%/tools/*}/tests/platforms/crevice_web_buffers.js" "${configs[-1]}"
check "meshes in buffers of the page's own are drawn as copies of them" \
    cmp "${configs[-1]}.buffers" "${configs[-1]}.web"
frame_ms=$(sed -n 's/.*<pre id="frame_ms">//p' buffers.dom)
check "a frame takes time on the GPU, and not '${frame_ms:-}' ms" awk "BEGIN { exit !(${frame_ms:-0} > 0) }"
printf 'crevice_web.wasm: %d bytes, %d with gzip -9\n' \
    "$(stat -c %s "$page/crevice_web.wasm")" "$(gzip -9c "$page/crevice_web.wasm" | wc -c)"
finish
