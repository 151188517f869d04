#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What takes too long for every change, once a night: builds the compilers of phones' GPUs, where they are not there,
# and asks them what the presets cost. The rest is tools/test.sh.
#
#   tools/scripts/nightly.sh
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
CREVICE_MOBILE_COMPILERS=$("$here/mobile_compilers.sh" | tail -n 1)
export CREVICE_MOBILE_COMPILERS
"$here/cost_figures.sh" --check
