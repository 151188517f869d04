#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes today's plans, and pictures drawn on EGL, the approved ones in tests/data. Look at `git diff` and at the pictures
# before you commit.
#
#   tools/scripts/approve.sh          plans and pictures
#   tools/scripts/approve.sh plans    plans alone, which need no GL
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
[[ $# == 0 || $* == plans ]] || { echo "usage: tools/scripts/approve.sh [plans]" >&2; exit 2; }

export CREVICE_APPROVE=1
cmake --preset ci
cmake --build --preset ci --target crevice_tests
rm -f tests/data/plans/*.txt
build/ci/tests/crevice_tests "The plan of every shipped config*"
if (($# == 0)); then
    cmake --build --preset ci --target crevice_gl_tests
    CREVICE_REQUIRE_GL=1 CREVICE_BACKEND=egl build/ci/tests/crevice_gl_tests "*draws the approved*"
fi
git status --short tests/data
