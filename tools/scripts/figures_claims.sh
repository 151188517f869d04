# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154  # work is its folder
# For tools/scripts/figures.sh, which sources this: measures what authors claim of ambient occlusion, for the table of
# docs/contributing/claims.md.

claims() {
    local gap scene kernel=/generated/kernel/lengths noise=/generated/rotation_noise/count
    local slats=(--camera 'eye=0.6,0.4,2.6;at=0,0,0') ours=(room hemisphere_box)
    claim() { cell "$1" measured "$2"; }
    darker() { draw ao.pfm plane "$@"; difference bias ao.pfm plane.pfm | tr -d -; }  # than open; CONFIG [OPTION...]
    tile() { error "${ours[@]}" --set samples=8 --set "$noise=$1" --set "blur_size=$1"; }
    noisy() { echo "$(error "${ours[@]}" "${@/#/--set=}") ($(difference rmse ao.pfm many.pfm))"; }
    unrotated() { noisy "samples=$1" "$noise=1" blur_size=1; }
    behind_slats() {  # CONFIG [OPTION...]: by how much the mean AO is off with slats 0.3 and 0.6 before the wall
        local gap
        for gap in 3 6; do
            draw ao.pfm "$work/slats$gap.obj" "$@" "${slats[@]}"
            difference bias ao.pfm "slats$gap.pfm"
        done | paste -sd ' '
    }
    for scene in room spheres plane; do ground_truth "$scene.pfm" "$scene"; done
    for gap in 3 6; do  # a wall with slats of 2 cm in front of it, every 40 cm
        awk -v gap="0.$gap" '
            function box(x0, x1, z0, z1,  i, c) {
                for (i = 0; i < 8; ++i) print "v", (i % 2 ? x1 : x0), (int(i / 2) % 2 ? 2 : -2), (i > 3 ? z1 : z0)
                split("1 3 4 2,5 6 8 7,1 2 6 5,3 7 8 4,1 5 7 3,2 4 8 6", faces, ",")
                for (i = 1; i <= 6; ++i) { split(faces[i], c, " "); print "f", c[1] + k, c[2] + k, c[3] + k, c[4] + k }
                k += 8
            }
            BEGIN {
                box(-3, 3, -0.2, 0)
                for (i = -7; i <= 7; ++i) box(0.4 * i - 0.01, 0.4 * i + 0.01, gap, gap + 0.02)
            }' >"$work/slats$gap.obj"
        ground_truth "slats$gap.pfm" "$work/slats$gap.obj" "${slats[@]}"
    done
    draw many.pfm "${ours[@]}" --set samples=250 --set blur_size=1
    draw one.pfm room thesis --set filter/bilateral=filter/bilateral_2d
    draw two.pfm room thesis
    {
        claim '64 samples' "64 $(error room learnopengl), 32 $(error room learnopengl --set samples=32), 16 $(error room learnopengl --set samples=16)"
        claim 'Samples near' "even $(error "${ours[@]}"), linear $(error "${ours[@]}" --set $kernel=linear), quadratic $(error "${ours[@]}" --set $kernel=quadratic)"
        claim 'A hemisphere' "\`sphere_box\` with 32 $(error spheres sphere_box), \`hemisphere_box\` with 16 $(error spheres hemisphere_box --set samples=16)"
        claim 'A sphere kernel' "\`ogldev45\` $(darker ogldev45), \`sphere_box\` $(darker sphere_box), \`hemisphere_box\` $(darker hemisphere_box)"
        claim 'Two passes' "$(difference rmse one.pfm two.pfm)"
        claim 'Noise tiles' "2x2 $(tile 2), 4x4 $(tile 4), 8x8 $(tile 8), 16x16 $(tile 16)"
        claim '200 samples' "16 $(noisy samples=16); unrotated 64 $(unrotated 64), 128 $(unrotated 128), 250 $(unrotated 250)"
        claim 'Without a range check' "with $(error spheres learnopengl), without $(error spheres learnopengl --variant no_range_check)"
        claim 'Without a bias' "with $(darker habr), without $(darker habr --variant without_bias)"
        claim 'A power' "visibility $(error room chapman_depth), occlusion $(error room chapman_depth --variant as_written)"
        claim 'What is off' "without a guard band $(error room gtao --set guard_band=1), with $(error room gtao)"
        claim 'A filter' "$(error room gtao), with \`box\` $(error room gtao --set filter/bilateral_normal=filter/box)"
        claim 'Horizons' "\`hbao\` $(error room hbao), \`gtao\` $(error room gtao), \`hemisphere_box\` $(error "${ours[@]}")"
        claim 'Thin objects' "no AO $(behind_slats gtao --set intensity=0), \`hbao\` $(behind_slats hbao), \`gtao\` $(behind_slats gtao), \`bitmask\` $(behind_slats bitmask), \`bitmask_back\` $(behind_slats bitmask_back)"
    } | fill claims
}
