#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Takes what is planned and drawn now, on EGL, as the approved plans and pictures in tests/data. Look at
# the pictures and at `git diff` before you commit; OSMesa is then compared with the same pictures.
#
#   tools/scripts/approve.sh          plans and pictures
#   tools/scripts/approve.sh plans    the plans alone, which need no GL
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
if (($# > 1)) || [[ ${1:-plans} != plans ]]; then
    echo "usage: tools/scripts/approve.sh [plans]" >&2
    exit 2
fi

cmake --preset ci
cmake --build --preset ci --target crevice_tests
rm -f tests/data/plans/*.txt
CREVICE_APPROVE=1 build/ci/tests/crevice_tests "The plan of every shipped config*"
if (($# == 0)); then
    cmake --build --preset ci --target crevice_gl_tests
    mkdir -p tests/data/golden
    CREVICE_APPROVE=1 CREVICE_REQUIRE_GL=1 CREVICE_BACKEND=egl \
        build/ci/tests/crevice_gl_tests "*draws the approved*"
fi
git status --short tests/data
