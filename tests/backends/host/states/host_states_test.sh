#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Hosts in random states, in contexts of several versions, which Mesa's switches make.
#   host_states_test.sh CREVICE_GL_TESTS [es32|es30|gl45|gl33|compatibility]...
# Without names all of them. CREVICE_HOST_STATES is how many states in each.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/../../old_gl.sh"
tests=$1
shift
(($# > 0)) || set -- es32 es30 gl45 gl33 compatibility

for context; do
    case $context in
    es32) switches=(CREVICE_BACKEND=egl) ;;
    es30) switches=(CREVICE_BACKEND=egl MESA_GLES_VERSION_OVERRIDE=3.0) ;;
    gl45) switches=(CREVICE_BACKEND=osmesa) ;;
    gl33) switches=(CREVICE_BACKEND=osmesa "${gl33[@]}") ;;
    compatibility) switches=(CREVICE_BACKEND=osmesa MESA_GL_VERSION_OVERRIDE=4.5COMPAT) ;;
    *) echo "no such context: $context" >&2 && exit 2 ;;
    esac
    env "${switches[@]}" "$tests" "Hosts *"
done
