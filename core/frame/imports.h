// SPDX-License-Identifier: MIT
// What a host supplies.
#pragma once

namespace crevice {

enum class ImportType { camera, draw_list, lights, texture };

}  // namespace crevice
