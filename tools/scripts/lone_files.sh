#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Each source file of the libraries and tools compiles alone, by clang: builds unite ten of them, which would hide what a
# file forgets to include. Files of tests are never united.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
build=build/lone_files
cmake -G Ninja -S . -B $build -DCMAKE_CXX_COMPILER=clang++ -DCREVICE_WERROR=ON -DCREVICE_TESTS=OFF >/dev/null
python3 - $build/compile_commands.json <<'PYTHON' | xargs -0 -n 1 -P "$(nproc)" bash -c
import json, re, sys
for each in json.load(open(sys.argv[1])):
    if "/build/" not in each["file"]:
        print("cd", each["directory"], "&&", re.sub(r" -o \S+ -c ", " -fsyntax-only ", each["command"]), end="\0")
PYTHON
