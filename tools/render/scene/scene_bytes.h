// SPDX-License-Identifier: MIT
// A scene as one string of bytes, from a program to another of the same version: to a page, or from
// a page to its workers. It is no file format.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// All of the scene. The same scene gives the same bytes, on 32 and on 64 bits.
std::string sceneBytes(const Scene& scene);

/// Whether all that it refers to is there, and its pictures are whole.
bool isSound(const Scene& scene);

/// What `sceneBytes` wrote, or something else: nothing is read behind the end, memory is taken in
/// proportion to what is there, and all that the scene refers to exists.
///
/// Errors: CV7002 for bytes that are cut or changed, of another version, or of a machine with
/// another order of bytes; CV7003 for a scene without a triangle.
Result<Scene> sceneFromBytes(std::string_view bytes);

}  // namespace crevice
