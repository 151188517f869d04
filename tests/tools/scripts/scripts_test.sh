#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# install_packages.sh against a pretended system: what it does where packages are missing, where they
# cannot be had, and where this is no Debian. Nothing is installed.
#   scripts_test.sh INSTALL_PACKAGES
set -euo pipefail
script=$1
work=$(mktemp -d "${TMPDIR:-/tmp}/crevice scripts.XXXXXX")
trap 'rm -rf -- "$work"' EXIT
failures=0

# Commands that the script may use, but for those that a case takes away.
tools=$work/tools
mkdir -p "$tools"
for command in bash env dirname sed cat; do ln -s "$(command -v "$command")" "$tools/$command"; done

# pretend NAME LINES: a command of that name, in front of all others.
pretend() { printf '#!/usr/bin/env bash\n%s\n' "$2" >"$work/bin/$1" && chmod +x "$work/bin/$1"; }
new_system() { rm -rf "$work/bin" && mkdir -p "$work/bin" && rm -f "$work/log"; }

# expect CODE PATTERN ARGUMENTS...
expect() {
    local code=$1 pattern=$2 got=0
    shift 2
    PATH="$work/bin:$tools" LOG="$work/log" bash "$script" "$@" >"$work/output" 2>&1 || got=$?
    if ((got != code)) || ! grep -qE -- "$pattern" "$work/output"; then
        failures=$((failures + 1))
        printf 'FAILED: exit code %d, wanted %d and /%s/\n' "$got" "$code" "$pattern"
        sed 's/^/  | /' "$work/output"
    fi
}
installed='printf installed'

new_system
expect 1 'no Debian system.*cmake|no Debian system'

new_system
pretend dpkg-query "$installed"
pretend apt-get 'echo "$@" >>"$LOG"; exit 1'
expect 0 'packages are there'
[[ ! -e $work/log ]] || { echo "FAILED: apt-get ran though nothing was missing"; failures=1; }

new_system
pretend dpkg-query '[[ ${!#} == ninja-build ]] || printf installed'
pretend apt-get 'echo "$@" >>"$LOG"'
pretend sudo 'exec "$@"'
expect 0 'Installing: ninja-build$'
grep -q 'install --yes --no-install-recommends ninja-build$' "$work/log" ||
    { echo "FAILED: ninja-build was not installed:"; cat "$work/log"; failures=1; }

new_system
pretend dpkg-query '[[ ${!#} == no-such-package ]] || printf installed'
pretend apt-get '[[ ${!#} != no-such-package ]]'
pretend sudo 'exec "$@"'
expect 1 "'no-such-package' cannot be had" no-such-package

if ((EUID != 0)); then
    new_system
    pretend dpkg-query 'true'
    pretend apt-get 'true'
    expect 1 'need root or sudo'
fi
((failures == 0)) && echo "all checks passed"
