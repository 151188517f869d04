#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# mobile_compilers.sh and what runs it, with pretended apt-get, meson and ninja: what it leaves behind, that it does nothing
# twice, and that each step which fails ends in one message with a way out. Nothing is installed, fetched or built.
#   mobile_compilers_test.sh SOURCE
set -euo pipefail
source=$1
work=$(mktemp -d "${TMPDIR:-/tmp}/crevice compilers.XXXXXX")
trap 'rm -rf -- "$work"' EXIT
failures=0
fail() { printf 'FAILED: %s\n' "$1"; sed 's/^/  | /' "$work/output"; failures=$((failures + 1)); }

mkdir -p "$work/tools/scripts" "$work/tools/cost" "$work/bin" "$work/mesa-22"
cp -- "$source"/tools/scripts/{mobile_compilers,nightly,cost_figures,built_crevice}.sh "$work/tools/scripts/"
echo x >"$work/tools/cost/compile_programs.c"
tar -czf "$work/mesa.tar.gz" -C "$work" mesa-22
# pretend FILE LINES: a command whose lines run unless it is the one that BREAK names.
pretend() {
    printf '#!/usr/bin/env bash\n[[ ${BREAK:-} != "%s" ]] || { echo "no %s today"; exit 1; }\n%s\n' \
        "${1##*/}" "${1##*/}" "$2" >"$work/$1"
    chmod +x "$work/$1"
}
pretend tools/scripts/install_packages.sh 'echo "$@" >>"$LOG"'
pretend bin/apt-get '[[ " $* " != *" source "* ]] || cp "$TARBALL" mesa_22.3.6.orig.tar.gz'
pretend bin/meson 'mkdir -p build; echo "$PWD" >build/where'
pretend bin/ninja '[[ -n ${NO_DRIVERS:-} ]] && exit 0
mkdir -p inst/lib inst/dri
touch inst/lib/lib{EGL.so.1,GLESv2.so.2,{panfrost,freedreno,v3d}_noop_drm_shim.so} inst/dri/{panfrost,msm,v3d}_dri.so
echo built >>"$LOG"'
pretend bin/cc 'while [[ $1 != -o ]]; do shift; done; echo program >"$2"'
export LOG=$work/log TARBALL=$work/mesa.tar.gz CC=$work/bin/cc HOME=$work XDG_CACHE_HOME=
unset CREVICE_MOBILE_COMPILERS
# The script puts the system's own folder first, for Python: meson and ninja are found through a function of the shell.
meson() { "$BIN/meson" "$@"; }
ninja() { "$BIN/ninja" "$@"; }
apt-get() { "$BIN/apt-get" "$@"; }
export BIN=$work/bin
export -f meson ninja apt-get

# expect CODE PATTERN ARGUMENTS...
expect() {
    local code=$1 pattern=$2 got=0
    shift 2
    bash "$work/tools/scripts/mobile_compilers.sh" "$@" >"$work/output" 2>&1 || got=$?
    ((got == code)) && grep -qE -- "$pattern" "$work/output" || fail "exit code $got, wanted $code and /$pattern/"
}

folder="$work/a folder"
for step in install_packages.sh:'Installing packages' apt-get:"Fetching Mesa's source" meson:'Configuring Mesa' \
    ninja:'Building Mesa' cc:'Building compile_programs.c'; do
    BREAK=${step%%:*} expect 1 "^mobile_compilers.sh: ${step#*:} failed; .*" "$folder"
    grep -qF "no ${step%%:*} today" "$work/output" || fail "the last lines of the log are not shown"
    [[ ! -e $folder/compile_programs ]] || fail "it looks finished after ${step%%:*} failed"
    rm -rf -- "$folder"
done
NO_DRIVERS=1 expect 1 'built without .*panfrost' "$folder"
rm -f -- "$LOG"
expect 0 "^$folder\$" "$folder"
grep -q 'python3-mako' "$LOG" || fail "the packages are not asked for"
[[ -e $folder/compile_programs && ! -e $folder/build && ! -e $folder/source ]] || fail "leftovers, or no program"
expect 0 "^$folder\$" "$folder"
[[ $(grep -c built "$LOG") == 1 ]] || fail "it builds twice"
expect 0 "^$work/.cache/crevice/mobile_compilers\$"
CREVICE_MOBILE_COMPILERS=$work/told expect 0 "^$work/told\$"
expect 2 'usage' one two
expect 2 'usage' --help
echo x >"$work/file"
expect 1 "cannot make the folder '$work/file/below'" "$work/file/below"

# The check finds the compilers where the script puts them, or says in one line that it is skipped.
pretend crevice 'echo "crevice $* in $CREVICE_MOBILE_COMPILERS"; exit 5'
export CREVICE=$work/crevice
got=0
CREVICE_MOBILE_COMPILERS=$work/none bash "$work/tools/scripts/cost_figures.sh" --check >"$work/output" 2>&1 || got=$?
((got == 77)) && grep -q '^SKIPPED: .*mobile_compilers.sh' "$work/output" || fail "no skip without compilers: $got"
got=0
CREVICE_MOBILE_COMPILERS=$folder bash "$work/tools/scripts/nightly.sh" >"$work/output" 2>&1 || got=$?
((got == 1)) && grep -qF "crevice cost --check docs/cost/phones.json in $folder" "$work/output" || fail "nightly: $got"
grep -q 'cost_figures.sh, and say why' "$work/output" || fail "the check names no way out"
((failures == 0)) && echo "all checks passed"
