#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# crevice view, as a user's shell and a browser see it.
#   view_test.sh CREVICE
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
command -v python3 >/dev/null || { echo "SKIPPED: there is no python3"; exit 77; }
source "$here/../../../support/cli_checks.sh"

mkdir page empty bin
echo '<!doctype html><title>page</title>' >page/index.html
echo 'export {};' >page/page.js
printf '\0asm' >page/crevice_page.wasm
echo secret | tee secret.txt page/.hidden >other.json
ln -s ../secret.txt page/link.txt
printf '{"format": 1, "extends": ["learnopengl", "./more/radius.json"]}\n' >mine.json
mkdir more
printf '{"format": 1, "params": {"radius": 0.8}}\n' >more/radius.json
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >model.obj

expect 0 'Examples:' view --help
expect 3 'CV7011.*empty' view --page empty --no-browser
expect 3 'help: build the page with tools/page.sh' view --page nowhere --no-browser
expect 2 'CV8001.*--port' view --page page --port 65536
expect 1 "CV1201.*did you mean 'mobile'|did you mean 'mobile'" view mobil --page page --no-browser
expect 1 "CV1201.*nowhere.json" view nowhere.json --page page --no-browser
expect 1 'CV7001' view --page page --scene nowhere.glb --no-browser
expect 1 'CV7004' view --page page --scene model.obj --camera nobody --no-browser

# The browser is told the address, as one argument, and is not waited for.
printf '#!/bin/sh\nprintf "%%s|" "$#" "$1" >"%s/opened"\nsleep 20\n' "$work" >bin/xdg-open
chmod +x bin/xdg-open

# serve PROGRAMS ARGUMENTS: runs $crevice, with a PATH of that, until it printed its address, which is left in $address.
serve() {
    local programs=$1
    shift
    rm -f address.txt
    PATH=$programs "$crevice" view "$@" >address.txt 2>messages.txt </dev/null &
    server=$!
    for _ in {1..200}; do
        [[ -s address.txt ]] && break
        sleep 0.05
    done
    address=$(cat address.txt)
}
# stopped SIGNAL: ends with exit code 0, soon.
stopped() {
    local got=0 begin=$SECONDS
    kill -"$1" "$server" && wait "$server" || got=$?
    ((got == 0 && SECONDS - begin < 5))
}

serve "$work/bin:$PATH" --page page
check "the address is one of this machine with a token" grep -qE \
    '^http://127\.0\.0\.1:[0-9]+/[0-9a-f]{32}/$' address.txt
for _ in {1..100}; do [[ -s opened ]] && break; sleep 0.05; done
check "the browser is opened there" test "$(cat opened)" = "1|$address|"
port=$(sed -E 's|.*:([0-9]+)/.*|\1|' address.txt)
expect 3 "CV6022.*$port" view --page page --port "$port" --no-browser
check "SIGTERM ends it in peace" stopped TERM
first=$address
serve /nonexistent --page page --port "$port"
check "a port may be chosen" grep -q "127.0.0.1:$port/" address.txt
check "each run has its own token" test "$first" != "$address"
check "without xdg-open the user is told" grep -q 'no xdg-open' messages.txt
check "and nothing else is wrong" test "$(wc -l <messages.txt)" = 2
check "SIGTERM ends this one too" stopped TERM

serve "$PATH" mine.json --scene model.obj --camera eye=1,2,3 --page page --no-browser
python3 "$here/view_requests.py" "$address" "$work" || failures=$((failures + 1))
check "an interrupt ends it in peace while pages are open" stopped INT

printf '{"format": 1, "extends": ["learnopengl"], "parms": {}}\n' >broken.json
serve "$PATH" broken.json --page page --no-browser
check "a config with a mistake is served" grep -q '^http' address.txt
check "and reported" grep -q 'broken.json:.*CV3001' messages.txt
check "an interrupt ends that in peace" stopped INT

# An installed command finds the page that is installed with it.
mkdir -p prefix/bin prefix/share/crevice
cp "$crevice" prefix/bin/crevice
cp -r page prefix/share/crevice
crevice=prefix/bin/crevice
serve "$PATH" gtao --scene street --no-browser
read_from() { no_proxy=* python3 -c 'import sys, urllib.request as r; print(r.urlopen(sys.argv[1]).read())' "$address$1"; }
check "the installed page is served" grep -q '<title>page' <(read_from '')
check "a shipped config has no files" grep -q '"editable":false,"files":{}' <(read_from view.json)
check "a built-in scene has its name" grep -q '"scene":{"builtin":"street"}' <(read_from view.json)
check "an interrupt ends the installed one" stopped INT
finish
