#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# EGL and OSMesa draw the same picture of every config: at most one pixel in a thousand is off by more than 2/255.
#   backends_agree_test.sh CREVICE
set -euo pipefail
configs=$(realpath -- "$(dirname -- "${BASH_SOURCE[0]}")/../../configs")
source "$(dirname -- "${BASH_SOURCE[0]}")/../support/cli_checks.sh"
source "$(dirname -- "${BASH_SOURCE[0]}")/old_gl.sh"

view=(--scene room --size 160x90)
# drawn CONFIG BACKEND: into BACKEND.png and BACKEND.pfm.
drawn() {
    local got=0
    "$crevice" render "$1" "${view[@]}" --backend "$2" --out "color=$2.png" --out "ao=$2.pfm" 2>stderr.txt || got=$?
    if ((got == 3)) && [[ -z ${CREVICE_REQUIRE_GL:-} ]]; then
        sed 's/^/SKIPPED: /' stderr.txt
        exit 77
    fi
    check "$1 is drawn on $2" test "$got" -eq 0
}
for config in "$configs"/*.json "$configs"/*/*.json; do
    config=$(basename -- "$config" .json)
    drawn "$config" egl
    drawn "$config" osmesa
    expect 0 'rmse' compare egl.png osmesa.png --max-abs 2/255 --max-bad-fraction 0.001
    expect 0 'rmse' compare egl.pfm osmesa.pfm --max-abs 2/255 --max-bad-fraction 0.001
done

# Desktop OpenGL 3.3 with nothing beyond draws the same too.
for config in learnopengl mobile balanced; do
    for backend in egl old; do
        switches=()
        [[ $backend == egl ]] || switches=("${gl33[@]}")
        got=0
        env "${switches[@]}" "$crevice" render "$config" "${view[@]}" --backend "${backend/old/osmesa}" \
            --out "ao=$backend.pfm" 2>stderr.txt >stdout.txt || got=$?
        check "$config is drawn on $backend" test "$got" -eq 0
    done
    expect 0 'rmse' compare egl.pfm old.pfm --max-abs 2/255 --max-bad-fraction 0.001
done
finish
