# SPDX-License-Identifier: MIT
# What cli_test.sh and cli_gl_test.sh share; they source it. $1 is the crevice command.
crevice=$1
work=$(mktemp -d "${TMPDIR:-/tmp}/crevice cli.XXXXXX")  # with a space, as users' folders have
trap 'rm -rf -- "$work"' EXIT
cd "$work"
failures=0
checks=0

# expect CODE PATTERN ARGUMENTS...: the exit code, and a regular expression that both streams together
# must match ("" for any).
expect() {
    local code=$1 pattern=$2 got=0
    shift 2
    checks=$((checks + 1))
    "$crevice" "$@" >stdout.txt 2>stderr.txt </dev/null || got=$?
    if ((got != code)) || ! grep -qE -- "$pattern" stdout.txt stderr.txt; then
        failures=$((failures + 1))
        printf 'FAILED: crevice %s\n  exit code %d, wanted %d and /%s/\n' "$*" "$got" "$code" "$pattern"
        sed 's/^/  | /' stdout.txt stderr.txt
    fi
}

# probe COMMAND...: runs it, with its exit code in $got; where that says that there is no context, the test is skipped.
probe() {
    got=0
    "$@" >stdout.txt 2>stderr.txt || got=$?
    ((got != 3)) || [[ -n ${CREVICE_REQUIRE_GL:-} ]] || { sed 's/^/SKIPPED: /' stderr.txt; exit 77; }
}

# stop SIGNAL FILE ARGUMENTS...: sends it to the command once FILE has a first result; its exit code is in $got.
stop() {
    "$crevice" "${@:3}" >stdout.txt 2>stderr.txt &
    local running=$!
    for ((wait = 0; wait < 500; ++wait)); do
        ! grep -qs '"key"' "$2" || break
        sleep 0.02
    done
    kill "-$1" "$running"
    got=0
    wait "$running" 2>/dev/null || got=$?
}

# check DESCRIPTION COMMAND...: the command succeeds.
check() {
    local description=$1
    shift
    checks=$((checks + 1))
    if ! "$@"; then
        failures=$((failures + 1))
        printf 'FAILED: %s\n' "$description"
    fi
}

# What the last `expect` printed to stdout is JSON.
expect_json() {
    printf 'file(READ stdout.txt text)\nstring(JSON kind TYPE "${text}")\n' >is_json.cmake
    check "the output is JSON" cmake -P is_json.cmake
}

# from_readme FILE [PAGE]: the fenced block that follows the line "<!-- FILE -->" in PAGE, seen from the folder of README.md,
# or in README.md itself; written to FILE.
from_readme() {
    local page=$readme
    [[ $# == 1 ]] || page=$(dirname -- "$readme")/$2
    awk -v mark="<!-- $1 -->" '
        $0 == mark { found = 1; next }
        found && /^```/ { if (inside) exit; inside = 1; next }
        found && inside { print }' "$page" >"$1"
    check "$page has a block for $1" test -s "$1"
}

finish() {
    printf '%d checks, %d failed\n' "$checks" "$failures"
    ((failures == 0))
}
