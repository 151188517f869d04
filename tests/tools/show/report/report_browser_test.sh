#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Opens a report in headless Chromium, points, clicks and types, and checks what the page shows. Exit
# code 77 (skipped) where there is no Chromium, 1 with CREVICE_REQUIRE_BROWSER set.
#   report_browser_test.sh CREVICE
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [[ -z $browser ]]; then
    echo "SKIPPED: no chromium; apt-get install chromium"
    [[ -n ${CREVICE_REQUIRE_BROWSER:-} ]] && exit 1 || exit 77
fi
source "$here/../../../support/cli_checks.sh"
source "$here/../../../support/bench_results.sh"
write_results
expect 0 'wrote' report results.jsonl

# show NAME [OPTION...]: what the probe finds in the page, in NAME.txt.
show() {
    local name=$1
    shift
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" \
        --window-size=520,900 "$@" --virtual-time-budget=5000 --dump-dom "file://$work/probe.html" \
        >"$name.html" 2>browser.log || { cat browser.log; false; }
    sed -n '/<pre id="found">/,/<\/pre>/p' "$name.html" | sed 's/.*<pre id="found">//' >"$name.txt"
}
# found LINE: the probe wrote it.
found() { check "the page shows $1" grep -qxF -- "$1" light.txt; }

{
    sed '/<\/html>/d; /<\/body>/d' report.html
    printf '<script>\n'
    cat "$here/report_probe.js"
    printf '</script>\n</body>\n</html>\n'
} >probe.html
show light --blink-settings=preferredColorScheme=1
show dark --blink-settings=preferredColorScheme=0

found 'marks=a16 a4 b16 b4 c4'
found 'onFront=a16 a4 b16 b4'
found 'titles=true'
found 'answer=Take fine samples=4'
found 'answerError=true'
found 'steps=4'
found 'openPanel=true'
found 'names=fine samples=16, fine samples=4, quick samples=4'
found 'hover=true'
found 'click=true'
found 'clickPictures=3'
found 'focus=true'
found 'enter=true'
found 'enterPictures=3'
found 'markup=0'
found 'budgets=5'
found 'motion=fine samples=40.0500.070––0.0123 (0.050, 0.250)––never1: 0.300 · at rest: 0.200'
found 'tableRows=5'
found 'missing=true'
found 'phone=true'
check "the page has a light and a dark side" \
    test "$(grep background= light.txt)" != "$(grep background= dark.txt)"
check "the page asks nothing of a network" bash -c \
    '! sed "s#http://www.w3.org/2000/svg##g" report.html | grep -qE "https?://|src=\"//|@import"'
if ((failures)); then cat light.txt; fi
finish
