#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Opens a report and the page of a matrix in headless Chromium, points, clicks and types, and checks what the pages show.
# Exit code 77 (skipped) where there is no Chromium, 1 with CREVICE_REQUIRE_BROWSER set.
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

# opened PAGE [OPTION...]: the page in the browser, as HTML.
opened() {
    local page=$1
    shift
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" \
        --window-size=520,900 "$@" --virtual-time-budget=5000 --dump-dom "file://$work/$page" \
        2>browser.log || { cat browser.log >&2; false; }
}
# show NAME [OPTION...]: what the probe finds in the page, in NAME.txt.
show() {
    local name=$1
    shift
    opened probe.html "$@" >"$name.html"
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
found 'names=fine samples=16, fine samples=4, quick samples=16, quick samples=4'
found 'answer=Take fine samples=4'
found 'steps=4'
found 'click=true'
found 'clickPictures=3'
found 'enter=true'
found 'markup=0'
found 'tableRows=5'
found 'motion=true'
found 'missing=true'
found 'phone=true'
check "the page has a light and a dark side" \
    test "$(grep background= light.txt)" != "$(grep background= dark.txt)"
if ((failures)); then cat light.txt; fi

# --- a matrix: what failed is chosen, and its slider moves the line ---
cat >matrix.json <<'JSON'
{ "format": 1, "configs": ["gtao", "learnopengl"], "scenes": ["corner", "spheres"], "sizes": ["96x64"],
  "checks": [{"approved": {"max": 0.02, "share": 0.001}}] }
JSON
expect 0 '' test matrix.json --approve
cp approved/matrix/{learnopengl,gtao}-spheres.ao.png  # as if gtao had drawn another picture before
expect 5 '' test matrix.json --out changed
cat >>changed/index.html <<'HTML'
<script>
const slider = document.querySelector('input[type="range"]');
slider.value = 20;
slider.dispatchEvent(new Event("input"));
document.title = document.querySelectorAll("section").length + " cells, " +
  document.querySelector(".wipe").style.getPropertyValue("--at");
document.querySelector('input[type="checkbox"]').click();
document.title += ", " + document.querySelectorAll("section").length + " in all";
</script>
HTML
opened changed/index.html >matrix.html
check "the page of a matrix" grep -q '<title>1 cells, 20%, 4 in all</title>' matrix.html
finish
