#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up what is missing and runs the checks. Warnings are errors everywhere. Safe to run again.
#
#   tools/test.sh            what every contributor runs: all tests but the slow ones; ten minutes on two cores
#   tools/test.sh --all      the rest too, as continuous integration does: 35 minutes
#   tools/test.sh --nightly  all of it, whole where the others take samples, and costs on phones: two hours
#
# Where ccache is installed, what was compiled before is not compiled again, in another clone either; CCACHE_DISABLE=1
# compiles all of it.
# With CI=true a missing GL context, browser or schema validator is a failure, not a skip.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

# Which run has the stage first, its budget in seconds on two cores with nothing compiled before, its function below,
# and its title. A stage that takes longer than its budget says so.
stages='
contributor |   60 | packages         | Packages (tools/scripts/packages.txt)
contributor |  330 | build            | Building, with warnings as errors
contributor |  180 | tests            | Tests
contributor |  100 | costs            | Costs on phones, where their compilers are built
all         |  100 | full_packages    | Packages for the stages below
all         |  100 | full_tests       | Tests on OSMesa, of stress, and of pages in a browser
all         |   60 | guard            | Errors against docs/bench
all         |   20 | pictures         | Pictures in the documentation
all         |  100 | shader_faults    | Faults planted in shaders, which stress must find
all         |  460 | sanitized_tests  | Tests of what owns memory, by clang, under sanitizers
all         |   60 | fuzzers          | Fuzzers, 15 seconds each
all         |  115 | threads          | Threads under the thread sanitizer
all         |  125 | lone_files       | Each file compiles alone, by clang
all         |   20 | debian_packages  | Debian packages
all         |  110 | web              | WebGL 2 in a browser
all         |   90 | page             | The page in a browser
all         |  165 | arm              | arm64 and armv7, under qemu
all         |   60 | sizes            | What the runtime adds to a program on arm64
nightly     | 1800 | phones           | Costs on phones against docs/cost
nightly     | 1200 | code_faults      | Faults planted in C++, which tests must find
nightly     |  600 | bare_debian      | The packages on a bare Debian
'

run=contributor
case ${1:-} in
    "") ;;
    --all) run=all ;;
    --nightly) run=nightly ;;
    *) echo "usage: tools/test.sh [--all | --nightly]" >&2; exit 2 ;;
esac
[[ ${CI:-} != true ]] || export CREVICE_REQUIRE_GL=1 CREVICE_REQUIRE_BROWSER=1 CREVICE_REQUIRE_JSONSCHEMA=1
[[ $run != nightly ]] || export CREVICE_NIGHTLY=1
export CREVICE=$PWD/build/ci/tools/crevice

options=()
if [[ -z ${CCACHE_DISABLE:-} ]] && command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
    options+=(-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)  # which it cannot keep
fi

packages() { tools/scripts/install_packages.sh; }
build() { cmake --preset ci "${options[@]}" && cmake --build --preset ci; }
tests() { ctest --preset ci --no-tests=error --parallel 2 --label-exclude 'full|nightly'; }
costs() { or_skipped tools/scripts/figures.sh cost --check; }
full_tests() { ctest --preset ci --no-tests=error --parallel 2 --label-regex full; }
full_packages() {
    local npm=
    command -v npm >/dev/null || npm="nodejs npm"
    # shellcheck disable=SC2086
    tools/scripts/install_packages.sh chromium clang debootstrap emscripten $npm \
        g++-aarch64-linux-gnu g++-arm-linux-gnueabihf qemu-user-static
}
guard() { tools/scripts/guard_bench.sh --errors-only; }
pictures() { tools/scripts/pictures.sh --check; }
shader_faults() { tests/faults/shaders.sh "$CREVICE" .; }
sanitized_tests() {
    cmake --preset asan "${options[@]}" && cmake --build --preset asan &&
        seq 0 7 | xargs -P "$(nproc)" -I{} bash tests/in_parts.sh build/asan/tests/crevice_memory_tests {} 8
}
fuzzers() { tests/fuzz/run.sh "$([[ $run == nightly ]] && echo 600 || echo 15)"; }
threads() {
    cmake --preset tsan "${options[@]}" && cmake --build --preset tsan && build/tsan/tests/crevice_thread_tests
}
lone_files() { tools/scripts/lone_files.sh; }
debian_packages() { tools/scripts/debian_packages.sh --built build/ci; }
bare_debian() { tools/scripts/debian_packages.sh --bare; }
web() { or_skipped tests/platforms/web_test.sh build/ci; }
page() { or_skipped tests/tools/show/page/page_test.sh "$CREVICE"; }
arm() {
    local scope=()
    [[ $run != nightly ]] || scope=(all)
    or_skipped tests/platforms/arm_test.sh aarch64-linux-gnu build/ci "${scope[@]}" &&
        or_skipped tests/platforms/arm_test.sh arm-linux-gnueabihf build/ci "${scope[@]}"
}
sizes() { or_skipped tools/scripts/sizes.sh --check; }
phones() {
    CREVICE_MOBILE_COMPILERS=$(tools/scripts/mobile_compilers.sh | tail -n 1) && export CREVICE_MOBILE_COMPILERS &&
        ctest --preset ci --no-tests=error --label-regex nightly && tools/scripts/figures.sh cost --check
}
code_faults() { tests/faults/run.sh build/faults; }

# Runs a command that exits with 77 where this machine lacks something, and says so itself.
or_skipped() {
    local code=0
    "$@" || code=$?
    ((code == 0)) || { ((code == 77)) && skipped+=("$title"); }
}

# Goes on where a stage fails, so that one run shows everything.
passed=0 skipped=() failed=() taken=()
while IFS='|' read -r first budget command title; do
    read -r first budget command <<<"$first $budget $command"
    [[ -n $first && ($first == contributor || $first == "$run" || $run == nightly) ]] || continue
    printf '\n==%s\n' "$title"
    begin=$SECONDS
    if "$command" </dev/null; then passed=$((passed + 1)); else failed+=("$title"); fi
    spent=$((SECONDS - begin)) over=
    ((spent <= budget)) || over="  OVER ITS BUDGET of $budget s"
    taken+=("$(printf '%5d s %s%s' $spent "$title" "$over")")
done <<<"$stages"

printf '\n'
printf '%s\n' "${taken[@]}" "$(printf '%5d s  together' $SECONDS)"
if ((${#skipped[@]})); then printf 'SKIPPED, at least in part:%s\n' "${skipped[@]}"; fi
if ((${#failed[@]})); then printf 'FAILED:%s\n' "${failed[@]}"; fi
printf 'Stages: %d passed, %d failed, %d skipped\n' $passed ${#failed[@]} ${#skipped[@]}
((${#failed[@]} == 0))
