# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2034
# Desktop OpenGL 3.3 with nothing beyond: no shaders of OpenGL ES, no storage of fixed size, no window depth in
# floats. Mesa's switches stand for a driver that has no more.
gl33=(MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330
    "MESA_EXTENSION_OVERRIDE=-GL_ARB_ES3_compatibility -GL_ARB_ES3_1_compatibility -GL_ARB_ES3_2_compatibility -GL_ARB_ES2_compatibility -GL_ARB_texture_storage -GL_ARB_clip_control -GL_ARB_transform_feedback2 -GL_ARB_get_program_binary -GL_ARB_internalformat_query -GL_ARB_invalidate_subdata")
