#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What crevice adds to a C host that draws AO of its own depth by `mobile`: stripped, MinSizeRel, in bytes; by the
# runtime with a baked effect, and by the whole library with that config embedded. And what each folder of the sources
# has of it, by the linker's map. Prints the tables of docs/reference/baked.md.
#   sizes.sh            arm64 and armv7; needs g++-aarch64-linux-gnu, g++-arm-linux-gnueabihf
#   sizes.sh --check    arm64 and the runtime alone, which must be within 5 % of the table
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
source tools/scripts/built_crevice.sh
crevice=$(realpath -- "$CREVICE")
table=docs/reference/baked.md
config=mobile+geometry/host_depth
triplets=(aarch64-linux-gnu arm-linux-gnueabihf)
unity=()  # which hides which file has what
if [[ ${1:-} == --check ]]; then
    triplets=(aarch64-linux-gnu)
    unity=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=10)
fi
for triplet in "${triplets[@]}"; do
    command -v "$triplet-g++" >/dev/null && continue
    echo "SKIPPED: no $triplet-g++; apt-get install g++-$triplet"
    exit 77
done
"$crevice" bake "$config" --output ao --header "$work/baked.h" 2>/dev/null

# link TRIPLET NAME ARGUMENT...: a stripped host, its map beside it; prints its bytes
link() {
    local triplet=$1 name=$2
    "$triplet-gcc" -std=c99 -Os -ffunction-sections -fno-asynchronous-unwind-tables -Ieffects/api/c/include -I"$work" \
        -s -Wl,--gc-sections -Wl,-z,max-page-size=4096 "-Wl,-Map=$work/$name.map" tests/platforms/size_host.c \
        tests/installed/find.c "${@:3}" -lstdc++ -lm -ldl -o "$work/$name" 2>"$work/link.txt" || { cat "$work/link.txt" >&2; exit 1; }
    stat -c %s "$work/$name"
}

# configure TRIPLET ARGUMENT...: a build of the libraries; prints its folder
configure() {
    local build=build/sizes_$1${unity:+_check}
    quietly cmake -G Ninja -S . -B "$build" --toolchain "tools/cmake/$1.cmake" -DCMAKE_BUILD_TYPE=MinSizeRel \
        -DCMAKE_CXX_FLAGS="-ffunction-sections -fdata-sections" -DCREVICE_TOOLS=OFF -DCREVICE_TESTS=OFF \
        -DCREVICE_INSTALL=OFF "${unity[@]}" -DCREVICE_EMBED="$config" "${@:2}"
    echo "$build"
}

# full TRIPLET BUILD: builds the whole library, and links a host with it
full() {
    quietly cmake --build "$2" --target crevice_c crevice_effects crevice_backends
    link "$1" "$1.full" "-DCONFIG=\"$config\"" "$2/effects/api/c/libcrevice.a" "$2/effects/libcrevice_effects.a" \
        "$2/backends/libcrevice_backends.a" "$2/core/libcrevice_core.a"
}

declare -A bytes
for triplet in "${triplets[@]}"; do
    build=$(configure "$triplet" -DCREVICE_IPO=ON)
    empty=$(link "$triplet" empty)
    quietly cmake --build "$build" --target crevice_runtime
    baked=$(link "$triplet" "$triplet.baked" -DBAKED "$build/effects/api/c/libcrevice_runtime.a")
    bytes[$triplet.baked]=$((baked - empty))
    [[ ${1:-} == --check ]] || bytes[$triplet.full]=$(($(full "$triplet" "$build") - empty))
done

if [[ ${1:-} == --check ]]; then
    now=${bytes[aarch64-linux-gnu.baked]}
    known=$(sed -n 's/^| arm64 | \([0-9,]*\) .*/\1/p' "$table" | tr -d ,)
    echo "crevice adds $now bytes to an arm64 host, $known by $table"
    ((now * 100 <= known * 105)) && exit 0
    echo "That is over 5 % more: make it less, or run tools/scripts/sizes.sh and put what it prints into $table" >&2
    exit 1
fi

thousands() { printf "%d" "$1" | sed ':a; s/\([0-9]\)\([0-9]\{3\}\)\($\|,\)/\1,\2\3/; ta'; }
echo '| processor | baked | full |'
echo '|---|---|---|'
for triplet in "${triplets[@]}"; do
    name=arm64
    [[ $triplet == aarch64* ]] || name=armv7
    echo "| $name | $(thousands "${bytes[$triplet.baked]}") | $(thousands "${bytes[$triplet.full]}") |"
done
echo
# By folder, which only a linker that takes object by object can tell.
full aarch64-linux-gnu "$(configure aarch64-linux-gnu -DCREVICE_IPO=OFF)" >/dev/null
echo '| folder, arm64 | full |'
echo '|---|---|'
python3 - "$work/aarch64-linux-gnu.full.map" <<'END' | sort
import collections, glob, re, sys
homes = {'crevice': 'effects/api/c', 'crevice_effects': 'effects/api'}
folders = {path.split('/')[-1]: '/'.join(path.split('/')[:-1]) for library in ('core', 'backends')
           for path in glob.glob(library + '/**/*.cpp', recursive=True) if 'recording' not in path}  # no host has it
sums, name = collections.Counter(), ''
for line in open(sys.argv[1], errors='replace'):
    if re.match(r' \.\S+$', line):
        name = line.strip()
        continue
    row = re.match(r' (\.\S+)? +0x[0-9a-f]+ +0x([0-9a-f]+) .*lib(\w+)\.a\((\w+\.cpp)\.o\)', line)
    section, name = (row and row[1]) or name, ''
    if not row or re.search(r' 0x0{16} ', line) or not re.match(r'\.(text|rodata|data|eh_frame|gcc_except)', section):
        continue
    home = homes.get(row[3]) or folders.get(row[4], 'other')
    sums['configs and modules' if row[4] == 'catalog_data.cpp' else home] += int(row[2], 16)
for home, size in sums.items():
    print('| `%s` | %s |' % (home, format(size, ',')))
END
