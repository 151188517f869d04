// SPDX-License-Identifier: MIT
// A description after it was baked and read again.
#pragma once

#include "tests/support/need.h"
#include "tools/bake/bake.h"

namespace crevice {

inline std::string bakedBytes(const Description& description, const BakeOptions& options = {})
{
    return need(bake({{description.name, {}, 0, 0, description}}, options));
}

inline Description readBack(const std::string& bytes)
{
    return need(readBaked(bytes.data(), bytes.size())).front().description;
}

inline Description throughBytes(const Description& description, const BakeOptions& options = {})
{
    return readBack(bakedBytes(description, options));
}

}  // namespace crevice
