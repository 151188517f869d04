#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the libraries, examples and tests for one ARM processor with Debian's compiler, and runs under qemu-user the
# tests of what differs between processors; and on that processor's Mesa, unpacked into the build folder, `mobile` and
# `balanced`, whose pictures must be those of this machine bit for bit. Exit code 77 (skipped) where the compiler or
# qemu is missing.
#   arm_test.sh TRIPLET BUILD [all]   aarch64-linux-gnu or arm-linux-gnueabihf; this machine's build
# With `all` (some ten minutes) every test that needs no tools, those of the backends with GL among them, the examples,
# and six configs.
set -euo pipefail
triplet=$1
native=$(realpath -- "$2")
scope=${3:-some}
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
toolchain=tools/cmake/$triplet.cmake
read -r -a emulator < <(sed -n 's/.*EMULATOR \(.*\))/\1/p' "$toolchain")
for command in "$triplet-g++" "${emulator[0]}"; do
    command -v "$command" >/dev/null && continue
    echo "SKIPPED: no $command; apt-get install g++-$triplet qemu-user-static"
    exit 77
done

build=build/$triplet
root=$build/root
declare -A architecture=([aarch64-linux-gnu]=arm64 [arm-linux-gnueabihf]=armhf)
gl_options=(-DCREVICE_GLES=)
if tests/platforms/debian_root.sh "$root" "${architecture[$triplet]}" \
    libegl1 libegl-mesa0 libgl1-mesa-dri libgles2 libstdc++6; then
    libraries=$PWD/$root/usr/lib/$triplet
    gl_options=(-DCREVICE_GLES="$libraries/libGLESv2.so.2" -DCMAKE_EXE_LINKER_FLAGS="-Wl,-rpath-link,$libraries")
    emulator+=(-L "$root")
fi
cmake -G Ninja -S . -B "$build" --toolchain "$toolchain" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=10 \
    -DCREVICE_WERROR=ON -DCREVICE_INSTALL=OFF -DCREVICE_TOOLS=OFF -DCREVICE_TESTS=OFF -DCREVICE_PLATFORM_TESTS="$scope" \
    "${gl_options[@]}" >/dev/null
cmake --build "$build" -- --quiet
programs=$build/tests/platforms
"${emulator[@]}" "$programs/crevice_platform_tests"
if [[ ! -e $root/complete ]]; then
    echo "SKIPPED: what draws, since Mesa cannot be had for ${architecture[$triplet]}"
    exit 0
fi

# softpipe computes the same everywhere; llvmpipe rounds otherwise from one kind of vector unit to the next, and
# on armv7 Mesa 22.3.6 draws white by it.
export GALLIUM_DRIVER=softpipe
work=$(mktemp -d "${TMPDIR:-/tmp}/crevice arm.XXXXXX")
trap 'rm -rf -- "$work"' EXIT
same() {
    cmp "$work/here" "$work/there" || exit 1
    echo "$1: the same as on $(uname -m)"
}
configs=(mobile balanced)
[[ $scope == all ]] && configs+=(high gtao hbao learnopengl)
for config in "${configs[@]}"; do
    "${emulator[@]}" "$programs/crevice_picture" "$config" 96 54 "$work/there"
    "$native/tests/platforms/crevice_picture" "$config" 96 54 "$work/here"
    same "$config"
done
[[ $scope == all ]] || exit 0
for example in hello hello_c; do
    "${emulator[@]}" "$programs/$example" >"$work/there"
    "$native/tools/examples/$example" >"$work/here"
    same "$example"
done
"${emulator[@]}" "$programs/crevice_platform_gl_tests"
