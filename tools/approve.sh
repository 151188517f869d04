#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Takes what is drawn now, on EGL, as the approved pictures in tests/data/golden. Look at the pictures
# and at `git diff` before you commit; OSMesa is then held against the same ones.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

cmake --preset ci
cmake --build --preset ci --target crevice_gl_tests
mkdir -p tests/data/golden
CREVICE_APPROVE=1 CREVICE_REQUIRE_GL=1 CREVICE_BACKEND=egl \
    build/ci/tests/crevice_gl_tests "*draws the approved*"
git status --short tests/data/golden
