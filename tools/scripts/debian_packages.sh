#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the Debian packages libcrevice0, libcrevice-dev and crevice-tools, and looks into them.
#
#   debian_packages.sh                 into build/deb
#   debian_packages.sh --built FOLDER  from what is built there, by the preset ci
#   debian_packages.sh --bare          installs them in a bare Debian 12 too, which debootstrap downloads (root,
#                                      network), and runs the command, and the examples built there, with Mesa's
#                                      software renderer
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
build=$PWD/build/deb
packages=(libcrevice0 libcrevice-dev crevice-tools)

bare=false built=false
case ${1:-} in
    "") ;;
    --built) built=true build=$(realpath -- "${2:?--built needs the folder of a build}") ;;
    --bare) bare=true ;;
    *) echo "usage: debian_packages.sh [--built FOLDER | --bare]" >&2; exit 2 ;;
esac
fail() { printf '%s\n' "$1" >&2; exit 1; }
for tool in dpkg-deb dpkg-shlibdeps; do
    command -v "$tool" >/dev/null || { echo "SKIPPED: $tool is not here; apt-get install dpkg-dev"; exit 77; }
done

if ! $built; then
    cmake -G Ninja -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_INSTALL_PREFIX=/usr \
        -DBUILD_SHARED_LIBS=ON -DCREVICE_TESTS=OFF
    cmake --build "$build"
fi
rm -f "$build"/*.deb
(cd "$build" && cpack -G DEB)

file_of() { find "$build" -maxdepth 1 -name "$1_*.deb"; }
field() { dpkg-deb -f "$(file_of "$1")" "$2"; }
holds() { grep -qE "$2" <<<"$(dpkg-deb -c "$(file_of "$1")")" || fail "$1 holds nothing like $2"; }
version=$(field libcrevice0 Version)
holds libcrevice0 'libcrevice[.]so[.]0$|libcrevice[.]so[.]0 -> '
holds libcrevice-dev 'libcrevice[.]so -> libcrevice[.]so[.]0'
for file in include/crevice/crevice.h include/crevice/effect.h libcrevice_core.a creviceConfig.cmake crevice.pc; do
    holds libcrevice-dev "${file//./[.]}\$"
done
holds crevice-tools 'bin/crevice$'
[[ $(field libcrevice0 Depends) == *libstdc++6* ]] || fail "libcrevice0 names no libraries that it needs"
[[ $(field libcrevice-dev Depends) == *"libcrevice0 (= $version)"*libglm-dev* ||
    $(field libcrevice-dev Depends) == *libglm-dev*"libcrevice0 (= $version)"* ]] ||
    fail "libcrevice-dev depends on $(field libcrevice-dev Depends)"
[[ $(field crevice-tools Recommends) == *libegl1* ]] || fail "crevice-tools recommends no EGL"
for package in "${packages[@]}"; do echo "$(file_of "$package"): $(field "$package" Depends)"; done
$bare || exit 0

root=$(mktemp -d "${TMPDIR:-/tmp}/crevice_debian.XXXXXX")
trap 'rm -rf -- "$root"' EXIT
chmod 755 "$root"
debootstrap --variant=minbase bookworm "$root" >"$build/debootstrap.log" || fail "see $build/debootstrap.log"
cp "$build"/*.deb "$root/tmp"
inside() { chroot "$root" env LC_ALL=C DEBIAN_FRONTEND=noninteractive bash -euc "$1"; }
echo "== the command, with what it recommends"
inside 'apt-get -q=2 update && apt-get -q=2 install -y /tmp/crevice-tools_*.deb >/tmp/apt.log'
inside 'cd /tmp && crevice --version && crevice render balanced --size 256x144 --out ao=ao.png && ls -l ao.png'
echo "== programs in C and C++, with the library: the examples as they are installed"
inside 'apt-get -q=2 install -y /tmp/libcrevice0_*.deb /tmp/libcrevice-dev_*.deb g++ pkg-config libgles-dev >/tmp/apt.log'
inside 'cp -r /usr/share/doc/libcrevice-dev/tools/examples/* /tmp'
inside 'cd /tmp && cc -std=c99 hello.c $(pkg-config --cflags --libs crevice) -lGLESv2 -o hello_c && ./hello_c'
static="-lcrevice_effects -lcrevice_backends -lcrevice_core"
inside "cd /tmp && c++ -std=c++17 hello.cpp $static -lGLESv2 -o hello && ./hello"
inside "cd /tmp/host_draws && c++ -std=c++17 main.cpp $static -lGLESv2 -o host_draws && ./host_draws skinned.json"
echo "== programs with windows, by SDL2 and GLFW"
inside 'apt-get -q=2 install -y libsdl2-dev libglfw3-dev xvfb xauth >/tmp/apt.log'
inside "cd /tmp && c++ -std=c++17 host_depth.cpp \$(pkg-config --cflags sdl2) $static -lSDL2 -lGLESv2 -o host_depth"
inside 'cd /tmp && SDL_VIDEODRIVER=offscreen ./host_depth 3'
inside "cd /tmp && c++ -std=c++17 desktop_gl.cpp $static -lglfw -lGL -o desktop_gl && xvfb-run -a ./desktop_gl 3"
