#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Plants single faults in the code, one at a time, and says which test finds each first. code.txt has the faults. All
# are compiled into one build of a copy of this checkout, where CREVICE_FAULT=NUMBER switches one of them on.
#   run.sh WORK_FOLDER [NUMBER...]    NUMBER: only these faults; 0 is none, which must not be found
# What WORK_FOLDER holds of a run before is not compiled again. CREVICE_JOBS faults are tried at a time, 2 by default.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
mkdir -p -- "${1:?usage: run.sh WORK_FOLDER [NUMBER...]}/tree" "$1/log"
work=$(cd -- "$1" && pwd)
shift
only=" $* " limit=${CREVICE_LIMIT:-400}  # seconds of one program; more is a fault that was found
renice -n 10 $$ >/dev/null
trap 'echo "run.sh: line $LINENO failed; see $work/log" >&2' ERR

# The tree, with all faults. Only files that changed are written, so that only these compile again.
rm -rf -- "$work/new" "$work"/log/*.found && mkdir "$work/new"
cd "$here/../.."
git ls-files -z -co --exclude-standard | xargs -0 cp --parents -t "$work/new" 2>/dev/null || true  # of deleted ones
cat >"$work/new/tests/faults/fault.h" <<'HEADER'
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdlib>
static inline bool isFault(int number)
{
    static const char* const text = std::getenv("CREVICE_FAULT");
    static const int chosen = text ? std::atoi(text) : 0;
    return number == chosen;
}
#define CREVICE_FAULT(number) isFault(number)
HEADER
cd "$work/new"
while IFS='|' read -r number file expression what; do
    before=$(<"${file// /}")
    sed -i "$(sed 's/^ *//; s/ *$//' <<<"$expression")" "${file// /}"
    [[ $before != "$(<"${file// /}")" ]] || { echo "fault $number changes nothing:$what" >&2; exit 1; }
done < <(grep -v '^#' "$here/code.txt")
grep -v '^#' "$here/code.txt" | cut -d'|' -f2 | sort -u | xargs sed -i '1i #include "tests/faults/fault.h"'
find . -type f | while IFS= read -r file; do cmp -s "$file" "../tree/$file" || cp --parents "$file" ../tree; done
cd "$work/tree"
find . -type f | while IFS= read -r file; do [[ -e ../new/$file ]] || rm "$file"; done
if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$work CCACHE_NOHASHDIR=1
fi
cmake -S . -B ../build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" >../log/cmake
cmake --build ../build --parallel 2 --target crevice_tests crevice_gl_tests crevice c_api_test_shared >../log/build

# fails LOG COMMAND...: whether it does, or takes too long; `why` is then the first test that failed.
fails() {
    local log=$1 name=${2##*/} code=0
    [[ $name != bash ]] || name=${3##*/}
    { timeout -k 10 $limit "${@:2}" >"$log" 2>&1 </dev/null; } 2>/dev/null || code=$?
    ((code != 0)) || return 1
    # Catch2 writes a test's name between two lines; parts of it are indented.
    why=$(awk '/^------+$/ { if (inside++) exit; next } inside && /^ / { exit } inside' "$log" | paste -sd ' ')
    [[ -n $why ]] || why=$(grep -m1 -oE 'FAILED: .*|[a-z_]+\.c:[0-9]+: .*' "$log" | sed 's/FAILED: //') || true
    why="$name: ${why:-exit code $code}"
    if ((code == 124 || code == 137)); then why+=", over $limit s"
    elif grep -q 'fatal error condition' "$log"; then why+=", crashed"; fi
}
unit() { fails "$own/unit" "$build/tests/crevice_tests" --abort -# "$@"; }
gl() { fails "$own/gl" "$build/tests/crevice_gl_tests" --abort -# "$@"; }
cli() { fails "$own/$1" bash "tests/tools/commands/$1.sh" "$build/tools/crevice" "$PWD/README.md" egl; }
in_c() { fails "$own/c" "$build/tests/c_api/c_api_test_shared"; }
# try NUMBER FILE: prints what came of it. The tests of the file's own folder go first, and then all.
try() {
    local own=$work/log/$1 build=$work/build begin=$SECONDS why='' each near folder=${2%/*}
    rm -rf -- "$own" && mkdir "$own"
    export CREVICE_FAULT=$1 CREVICE_REQUIRE_GL=1 CREVICE_BACKEND=egl XDG_CACHE_HOME=$own/cache
    folder=${folder/#effects\/api\/c/c_api}
    while [[ ! -d tests/$folder ]]; do folder=${folder%/*}; done
    near=$(find "tests/$folder" -name '*_test.cpp' -printf "[#%f]~In half floats*," | sed 's/\.cpp//g')
    case $folder in
        '') false ;; tools/commands) cli cli_test || cli cli_gl_test ;;
        c_api) unit "$near" || gl "$near" || in_c ;; *) unit "$near" || gl "$near" ;;
    esac || unit || gl "~In half floats*" || cli cli_test || cli cli_gl_test || in_c || true
    echo "$1 | $([[ -n $why ]] && echo "found by $why" || echo "NOT FOUND") ($((SECONDS - begin)) s)" | tee "$own.found"
}

../build/tests/crevice_tests -# --abort "[#compile_test],[#renderer_test],[#effect_test]" >../log/smoke
CREVICE_REQUIRE_GL=1 ../build/tests/crevice_gl_tests -# --abort "[#gl_device_gl_test]" >>../log/smoke
while IFS='|' read -r number file _; do
    number=${number// /}
    if [[ $only == "  " ]]; then ((number > 0)) || continue; elif [[ $only != *" $number "* ]]; then continue; fi
    while (($(jobs -rp | wc -l) >= ${CREVICE_JOBS:-2})); do wait -n; done
    try "$number" "${file// /}" &
done < <(echo "0 | |"; grep -v '^#' "$here/code.txt")
wait
missed=$(cat "$work"/log/*.found | grep -c '^[1-9].*NOT FOUND') || true
echo "$(cat "$work"/log/*.found | wc -l) faults, $missed not found"
((missed == 0))
