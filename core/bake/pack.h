// SPDX-License-Identifier: MIT
// Packed bytes: what stood before is named by how far back it was, as LZ77 does (Ziv, Lempel 1977).
//
// A row of steps, each of numbers as core/bake/archive.h writes them: bytes that follow; those
// bytes; bytes to repeat, and from how far back. `crevice bake` packs (tools/bake/pack.cpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace crevice {

/// What was packed, of `size` bytes; nothing where the bytes are damaged.
std::optional<std::string> unpack(std::string_view packed, std::size_t size);

}  // namespace crevice
