#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds what `crevice cost` asks: the shader compilers of phones' GPUs (Arm Mali, Qualcomm Adreno, Broadcom V3D). They
# are Mesa's drivers for them over stand-ins of their kernel drivers, from the source package of this Debian's Mesa. No
# such GPU is needed, and nothing of the system's Mesa changes. Prints the folder. Safe to run again; a folder that
# already has the drivers in inst/ only gets our own program.
#
#   tools/scripts/mobile_compilers.sh [FOLDER]    ten minutes on two cores, 1 GB; then they are there
#
# FOLDER: CREVICE_MOBILE_COMPILERS, or ${XDG_CACHE_HOME:-~/.cache}/crevice/mobile_compilers unless told. `crevice cost`
# looks in the same places. Packages need root or sudo where they are missing. What is printed on the way goes to
# FOLDER/build.log.
set -euo pipefail
if (($# > 1)) || [[ ${1:-} == -* ]]; then
    echo "usage: tools/scripts/mobile_compilers.sh [FOLDER]" >&2
    exit 2
fi
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
folder=${1:-${CREVICE_MOBILE_COMPILERS:-${XDG_CACHE_HOME:-$HOME/.cache}/crevice/mobile_compilers}}
fail() { printf 'mobile_compilers.sh: %s\n' "$1" >&2; exit 1; }
mkdir -p -- "$folder" && folder=$(cd -- "$folder" && pwd) || fail "cannot make the folder '$folder': name another one"
log=$folder/build.log

# step WHAT WAY_OUT COMMAND...: runs it with its output in the log; where it fails that is the last word.
step() {
    local what=$1 way_out=$2
    shift 2
    "$@" >>"$log" 2>&1 || fail "$what failed; $way_out. The last lines of $log:
$(tail -n 5 "$log" | sed 's/^/  | /')"
}

# What must be there in the end: a driver and its stand-in, for each kind of GPU.
drivers=(inst/lib/libEGL.so.1 inst/lib/libGLESv2.so.2)
for gpu in panfrost:panfrost freedreno:msm v3d:v3d; do
    drivers+=("inst/lib/lib${gpu%:*}_noop_drm_shim.so" "inst/dri/${gpu#*:}_dri.so")
done
has_drivers() {
    local file
    for file in "${drivers[@]}"; do [[ -e $folder/$file ]] || return 1; done
}

# Mesa's source, of the version that apt offers: lists of source packages of our own, beside the system's.
fetch_source() {
    mkdir -p sources lists/partial
    local list
    for list in /etc/apt/sources.list.d/*.sources; do
        [[ ! -e $list ]] || sed 's/^Types:.*/Types: deb-src/' "$list" >"sources/$(basename -- "$list")"
    done
    for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [[ ! -e $list ]] || sed -n 's/^deb /deb-src /p' "$list" >"sources/$(basename -- "$list" .list).list"
    done
    local apt=(apt-get --quiet --option Dir::Etc::sourcelist=/dev/null --option "Dir::Etc::sourceparts=$folder/sources"
        --option "Dir::State::lists=$folder/lists")
    rm -rf -- source mesa_*
    "${apt[@]}" update && "${apt[@]}" source --download-only mesa &&
        mkdir source && tar xf mesa_*.orig.tar.* -C source --strip-components=1
}

# No window system, no video, no LLVM: the compilers need none of it.
configure() {
    printf "[binaries]\npython3 = '/usr/bin/python3'\n" >native.ini
    rm -rf -- build
    meson setup build source --native-file native.ini --prefix="$folder/inst" --libdir=lib \
        -Dbuildtype=release -Db_ndebug=true -Dtools=drm-shim -Dgallium-drivers=panfrost,freedreno,v3d \
        -Dvulkan-drivers= -Dllvm=disabled -Dplatforms= -Degl=enabled -Dgbm=enabled -Dgles1=disabled -Dgles2=enabled \
        -Dglx=disabled -Dglvnd=false -Ddri-drivers-path="$folder/inst/dri" -Dgallium-vdpau=disabled \
        -Dgallium-va=disabled -Dgallium-xa=disabled
}

: >"$log"
export PATH=/usr/bin:$PATH  # Debian's Python first, which has mako: Mesa's scripts run whichever comes first
cd -- "$folder"
if ! has_drivers; then
    echo "mobile_compilers.sh: building in $folder; about ten minutes on two cores" >&2
    step "Installing packages" "see below which cannot be had" "$here/install_packages.sh" bison flex libdrm-dev \
        libelf-dev libexpat1-dev meson pkg-config python3-mako zlib1g-dev
    step "Fetching Mesa's source" "check the network and /etc/apt/sources.list, then run this again" fetch_source
    step "Configuring Mesa" "see $folder/build/meson-logs; this is tried on Debian 12's Mesa 22.3.6" configure
    step "Building Mesa" "free some memory or disk space (1 GB), then run this again" ninja -C build install
    has_drivers || fail "Mesa was built without ${drivers[*]}: this is tried on Debian 12's Mesa 22.3.6 alone"
    rm -rf -- build source mesa_*
fi
step "Building compile_programs.c" "install gcc, libegl-dev and libgles-dev" \
    "${CC:-cc}" -O1 "$here/../measure/cost/compile_programs.c" -o compile_programs.new -lEGL -lGLESv2
mv -f -- compile_programs.new compile_programs
echo "$folder"
