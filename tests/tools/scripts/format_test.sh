#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All C and C++ sources are as clang-format writes them, by .clang-format.   format_test.sh SOURCE
# Versions differ in details: exit code 77, a skip, where the installed one is not that of Debian 12.
set -euo pipefail
cd -- "$1"
version=$(clang-format --version 2>/dev/null | grep -oE '[0-9]+' | head -n1 || true)
if [[ $version != 14 ]]; then
    echo "SKIPPED: clang-format 14 is not here (found ${version:-none})"
    exit 77
fi
find core backends effects tools tests -name '*.h' -o -name '*.cpp' -o -name '*.c' | sort |
    xargs clang-format --dry-run --Werror || {
    echo "mend it: find core backends effects tools tests -name '*.h' -o -name '*.cpp' -o -name '*.c' | xargs clang-format -i"
    exit 1
}
echo "all sources are formatted"
