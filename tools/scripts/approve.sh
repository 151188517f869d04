#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes today's plans the approved ones in tests/data/plans. Look at `git diff` before you commit.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
export CREVICE_APPROVE=1
cmake --preset ci
cmake --build --preset ci --target crevice_tests
rm -f tests/data/plans/*.txt
build/ci/tests/crevice_tests "The plan of every shipped config*"
git status --short tests/data
