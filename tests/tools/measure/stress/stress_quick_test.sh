#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The quick subset of crevice stress: a preset, one for phones, an author's config over stored positions and
# one over depth alone hold at the ends of what is swept.
#   stress_quick_test.sh CREVICE BACKEND
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/../../../support/cli_checks.sh"

# The sound variant of an author's config: what the author lacks is on, and its strength is the ground truth's, as is
# that of the other author's.
cat >stored.json <<'EOF'
{ "format": 1, "name": "stored", "extends": ["learnopengl"],
  "params": { "bias": 0.05, "bias_length": 0, "intensity": 4 }, "features": { "guards": true, "basis": "rotated" },
  "generated": { "rotation_noise": { "generator": "rotation_noise" } } }
EOF
cat >depth_alone.json <<'EOF'
{ "format": 1, "name": "depth_alone", "extends": ["sao"], "params": { "intensity": 1.7 } }
EOF
configs=(gtao stored.json depth_alone.json)
cases=(plane_near_far plane_fov plane_grazing plane_orthographic plane_radius_px plane_samples
    units near_far projection offset radius_to_zero corner_radius samples no_op sizes empty meshes lights orientation inputs host_depth host_normal)
# stress_at SIZE FOLDER CONFIG...: adds to stdout.txt and stderr.txt.
stress_at() {
    "$crevice" stress "${@:3}" "${cases[@]/#/--case=}" --quick --size "$1" --backend "$backend" \
        --cache cache --out "$2" >>stdout.txt 2>>stderr.txt
}
backend=$2
probe stress_at 128x72 quick "${configs[@]}"
# At a quarter of the resolution that picture would leave 32x18 pixels.
phone=0
stress_at 256x144 phone mobile_low || phone=$?
# What screen-space occlusion cannot do (docs/reference/stress.md): radii past the picture, one tap a pixel.
known='^  (corner_radius .*; breaks at 10000|samples +holds at 16; breaks at 1): [0-9]+ % of '
unknown=$(grep -E 'breaks at|VOID' stdout.txt | grep -vE "$known" || true)
check "all else holds: $unknown" test -z "$unknown"
check "what does not is known, of the config that each is or extends" test "$got" -eq 0 -a "$phone" -eq 0
check "no step is worse than known" test "$(grep -c '^0 steps are worse than known' stdout.txt)" -eq 2
check "every config was drawn" test "$(grep -c '^[a-z]' stdout.txt)" -eq "$((${#configs[@]} + 1))"
finish
