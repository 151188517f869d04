#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Files of others: what they may make the crevice command read, print and write.
#   untrusted_files_test.sh CREVICE
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../support/cli_checks.sh"
source "$here/../../support/bench_results.sh"

# never_shows TEXT: the last `expect` did not print TEXT.
never_shows() {
    check "nothing shows $1" bash -c '! grep -qF -- "$0" stdout.txt stderr.txt' "$1"
}

# --- files outside of a config's folder ---
mkdir -p mine results
echo 'hunter2 is the password' >secret.env
config() { printf '{"format": 1, "name": "mine", "extends": ["learnopengl"%s]%s}\n' "$1" "${2:-}" >mine/mine.json; }
config ', "../secret.env"'
for command in validate explain 'explain --why radius' render doctor 'stress --list'; do
    expect 1 'mine.json:1:56: error CV1204|CV1204' $command mine/mine.json
    never_shows hunter2
    expect 1 'CV100' $command mine/mine.json --root .
done
expect 0 'CV1204' bench --list --config mine/mine.json
expect 0 'CV100' bench --list --config mine/mine.json --root .
expect 2 'CV8001' validate mine/mine.json --root nowhere
for name in ./../secret.env ../missing.env ./link.frag ./include.frag ./whole.frag "$PWD/secret.env" "$PWD/missing.env"; do
    config '' ", \"shaders\": {\"ssao\": {\"fragment\": \"$name\"}}"
    ln -sf ../secret.env mine/link.frag
    printf '#version 300 es\n#include "./../secret.env"\nvoid main() {}\n' >mine/include.frag
    printf '#version 300 es\n#include "%s/secret.env"\nvoid main() {}\n' "$PWD" >mine/whole.frag
    expect 1 'CV1204' validate mine/mine.json
    never_shows hunter2
    expect 1 'CV1204' validate mine/mine.json --json
    never_shows hunter2
done
expect 1 'CV1204' validate learnopengl --set /shaders/ssao/fragment=../secret.env
expect 1 'CV1204' validate learnopengl --set "/shaders/ssao/fragment=./../secret.env"
never_shows hunter2
config '' ", \"interfaces\": {\"mine\": \"$PWD/secret.env\"}"
expect 1 'CV1204.*outside of' validate mine/mine.json
config ", \"$PWD/secret.env\""
expect 1 'CV1204.*outside of' validate mine/mine.json
printf '{"format": 1, "name": "base", "extends": ["learnopengl"], "variants": {"low": {}}}\n' >base.json
config ', "../base.json"'
expect 0 'mine.json variant low: ok' validate mine/mine.json --root .
expect 0 'mine.json variant low: ok' validate mine/mine.json --root mine --root /

# --- what is no regular file, or has no end ---
mkfifo pipe.json pipe.png pipe.frag mine/results.jsonl
ln -s /dev/zero zero.json
ln -s /dev/zero zero.png
for file in pipe.json zero.json; do
    expect 1 'CV1201.*no regular file' validate "$file"
done
expect 1 'CV2104.*no regular file' validate learnopengl --set /shaders/ssao/fragment=./pipe.frag
for file in pipe.png zero.png /dev/zero; do
    expect 1 'CV7005.*no regular file' compare "$file" "$file"
done
for command in report 'choose --error 1' 'report mine --against'; do
    expect 1 'CV7009.*no regular file' $command mine mine
    expect 1 'CV7009.*no regular file' $command /dev/zero /dev/zero
done
truncate -s 1T huge.json
expect 1 'CV1006' validate huge.json
expect 1 'CV7005' compare huge.json huge.json
expect 1 'CV7009' report huge.json

# --- pictures of a report ---
cd results
write_results
cp a4.png ../outside.png
printf 'hunter2' >b4.png
ln -sf ../outside.png a16.png
sed -i 's|"ao_picture":"b16.png"|"ao_picture":"../outside.png"|; s|"ao_picture":"c4.png"|"ao_picture":"/etc/passwd"|' results.jsonl
cd ..
expect 0 'CV7005' report results --out page.html
check "four pictures are left out" test "$(grep -c CV7005 stderr.txt)" -eq 4
check "nothing of them is in the page" bash -c '! grep -qE "$(printf hunter2 | base64 | cut -c1-8)|$(head -c6 /etc/passwd | base64)" page.html'

# --- names that would control a terminal ---
bad=$(printf 'x\033]0;title\007\302\233\342\200\256\177y')
terminal='[[:cntrl:]]|'$(printf '\302\233|\342\200\256')
# quiet ARGUMENTS...: whatever comes of it, nothing that it prints controls a terminal.
quiet() {
    "$crevice" "$@" >stdout.txt 2>stderr.txt </dev/null || true
    check "there is output: crevice $*" bash -c 'cat stdout.txt stderr.txt | grep -q .'
    check "no control characters: crevice $*" bash -c '! cat stdout.txt stderr.txt | LC_ALL=C grep -qE "$0"' "$terminal"
}
escaped='x\u001b]0;title\u0007\u009b\u202e\u007fy'
printf '{"format": 1, "name": "%s", "extends": ["learnopengl"], "variants": {"%s": {}},
  "params": {"radius": {"label": "%s", "tooltip": "%s"}}}\n' "$escaped" "$escaped" "$escaped" "$escaped" >"$bad.json"
quiet validate "$bad.json"
quiet validate "$bad.json" --json
for format in text json dot; do
    quiet explain "$bad.json" --format "$format"
done
quiet explain "$bad.json" --why radius
quiet validate learnopengl --set "$bad=1" --json
quiet validate "$bad"
quiet compare "$bad" "$bad"
quiet stress --list "$bad"
printf '{"format": 1, "name": "a", "%s": 1, "extends": ["%s"]}\n' "$bad" "$escaped" >raw.json
quiet validate raw.json --json
sed "s/\"quick\"/\"$(printf '%s' "$escaped" | sed 's/\\/\\\\/g')\"/g; s/device A/$(printf '%s' "$escaped" | sed 's/\\/\\\\/g')/" \
    results/results.jsonl >results/strange.jsonl
quiet choose results/strange.jsonl --error 1
quiet report results/strange.jsonl --against results/results.jsonl
quiet report results/strange.jsonl --out page.html
check "the page turns no text" bash -c '! LC_ALL=C grep -qE "$0" page.html' "$(printf '\302\233|\342\200\256')"

# --- output that cannot be written ---
# full ARGUMENTS...: exit code 4 and one message where stdout takes nothing.
full() {
    local got=0
    "$crevice" "$@" >/dev/full 2>stderr.txt </dev/null || got=$?
    check "exit code 4, not $got: crevice $* >/dev/full" test "$got" -eq 4
    check "one message: crevice $* >/dev/full" test "$(grep -c 'CV7007: the output cannot be written' stderr.txt)" -eq 1
}
# closed FD ARGUMENTS...: nothing printed gets into the files that are written where that stream is closed.
expect 0 . bench --config learnopengl --scene plane --size 16x9 --rays 4 --no-cache --repeats 1 --out closed
for stream in 1 2; do
    got=0
    eval "\"\$crevice\" bench --config learnopengl --scene corner --size 16x9 --rays 4 --no-cache --repeats 1 --out closed$stream $stream>&-" || got=$?
    check "all of closed$stream is JSON" bash -c "! grep -v '^{.*}\$' closed$stream/results.jsonl"
done
got=0
"$crevice" validate learnopengl >&- 2>stderr.txt || got=$?
check "exit code 4, not $got, where standard output is closed" test "$got" -eq 4
full schema
full --help
full validate learnopengl
full validate raw.json --json
full explain learnopengl
full choose results/results.jsonl --error 1
full report results/results.jsonl --against results/results.jsonl
full report results/results.jsonl
full stress --list
full compare results/a4.png results/a4.png
got=$( (trap '' PIPE; "$crevice" schema 2>stderr.txt; echo $? >code.txt) | head -c1)
check "a closed pipe prints no error" test ! -s stderr.txt
check "its exit code is 4" test "$(cat code.txt)" -eq 4
finish
