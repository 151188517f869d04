#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up what is missing and runs every check: all tests, the errors of the shipped configs against
# docs/bench, the pictures of docs/reference, costs on phones, faults planted in shaders, the tests without GL under
# sanitizers, threads under the thread sanitizer, Debian packages, built with clang, a minute of
# fuzzing, and crevice in a browser and on ARM.
# Warnings are errors everywhere. Safe to run again.
#
#   tools/test.sh          all of it
#   tools/test.sh --quick  the tests alone
#
# Where ccache is installed, what was compiled before is not compiled again, in another clone either.
# With CI=true a missing GL context, browser or schema validator is a failure, not a skip.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

quick=false
for argument in "$@"; do
    case $argument in
        --quick) quick=true ;;
        *) echo "usage: tools/test.sh [--quick]" >&2; exit 2 ;;
    esac
done
if [[ ${CI:-} == true ]]; then
    export CREVICE_REQUIRE_GL=1 CREVICE_REQUIRE_BROWSER=1 CREVICE_REQUIRE_JSONSCHEMA=1
fi

options=()
if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
    options+=(-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)  # which it cannot keep
fi

failed=() taken=()
# Runs a stage, a function below, and goes on where it fails, so that one run shows everything.
stage() {
    local title=$1 command=$2 begin=$SECONDS
    printf '\n== %s\n' "$title"
    "$command" || failed+=("$title")
    taken+=("$((SECONDS - begin)) s  $title")
}

all_tests() {
    cmake --preset ci "${options[@]}" && cmake --build --preset ci && ctest --preset ci --parallel 2
}
guard() {
    CREVICE=build/ci/tools/crevice tools/scripts/guard_bench.sh --errors-only
}
pictures() {
    CREVICE=build/ci/tools/crevice tools/scripts/pictures.sh --check
}
costs_on_phones() {
    CREVICE=build/ci/tools/crevice or_skipped tools/scripts/figures.sh cost --check
}
# Runs the tests of a program in eight parts, as many at a time as there are cores. A test that is in no part fails it.
in_parts() {
    local tests=$1 work part code=0
    work=$(mktemp -d)
    "$tests" --list-test-names-only >"$work/all" || true  # whose exit code is their number
    for part in {0..7}; do
        # Unescaped, commas and brackets of a name are Catch2's own.
        awk "NR % 8 == $part" "$work/all" | sed 's/[][,\\"]/\\&/g' >"$work/part$part"
        "$tests" --input-file "$work/part$part" --list-test-names-only >>"$work/named" || true
    done
    diff <(sort "$work/all") <(sort "$work/named") || code=1
    printf '%s\n' {0..7} | xargs -P "$(nproc)" -I{} \
        bash -c '"$0" --input-file "$1/part{}" >"$1/log{}" 2>&1' "$tests" "$work" || code=1
    grep -hv '^Filters: ' "$work"/log* || true  # of which Catch2 prints every name
    rm -rf -- "$work"
    return $code
}
# Sanitized, -O2 takes twice as long to compile, which is most of this stage.
sanitized_tests() {
    cmake --preset asan "${options[@]}" -DCREVICE_WERROR=ON "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1" &&
        cmake --build --preset asan --target crevice_tests &&
        in_parts build/asan/tests/crevice_tests
}
threads() {
    cmake --preset tsan "${options[@]}" -DCREVICE_WERROR=ON && cmake --build --preset tsan &&
        build/tsan/tests/crevice_thread_tests
}
# Runs a command that exits with 77 where this machine lacks something, and says so itself.
or_skipped() {
    local code=0
    "$@" || code=$?
    ((code == 0 || code == 77))
}
# Whether it compiles, and what is packed: neither is optimised, which takes half of the time.
debian_packages() {
    CREVICE_CMAKE_OPTIONS="-DCREVICE_WERROR=ON -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE=-O0" \
        or_skipped tools/scripts/debian_packages.sh
}
web_page() {
    or_skipped tests/platforms/web_test.sh build/ci && or_skipped tests/tools/page/page_test.sh build/ci/tools/crevice
}
arm() {
    or_skipped tests/platforms/arm_test.sh aarch64-linux-gnu build/ci &&
        or_skipped tests/platforms/arm_test.sh arm-linux-gnueabihf build/ci
}
planted_faults() {
    tests/tools/stress/mutations_test.sh build/ci/tools/crevice .
}
fuzzers() {
    tests/fuzz/run.sh 30
}

printf '== Packages (tools/scripts/packages.txt)\n'
if $quick; then
    tools/scripts/install_packages.sh chromium
    stage "All tests" all_tests
else
    tools/scripts/install_packages.sh chromium clang
    command -v npm >/dev/null || npm="nodejs npm"
    # shellcheck disable=SC2086
    tools/scripts/install_packages.sh emscripten ${npm:-} g++-aarch64-linux-gnu g++-arm-linux-gnueabihf qemu-user-static ||
        echo "test.sh: the stages of WebGL 2 and ARM say what they lack" >&2
    stage "All tests" all_tests
    stage "Errors against docs/bench" guard
    stage "Pictures in docs/reference" pictures
    stage "Costs on phones against docs/cost" costs_on_phones
    stage "Faults planted in shaders, which stress must find" planted_faults
    stage "Tests without GL under the address and undefined-behaviour sanitizers" sanitized_tests
    stage "Threads under the thread sanitizer" threads
    stage "Debian packages, built with clang" debian_packages
    stage "WebGL 2 and the page in a browser" web_page
    stage "arm64 and armv7, under qemu" arm
    stage "Fuzzers, 30 seconds each" fuzzers
fi

printf '\n'
printf '%s\n' "${taken[@]}"
if ((${#failed[@]})); then
    printf '\nFAILED: %s\n' "${failed[@]}"
    exit 1
fi
printf '\nAll stages passed.\n'
