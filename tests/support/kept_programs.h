// SPDX-License-Identifier: MIT
// A host that keeps linked programs in memory.
#pragma once

#include <crevice/gl_device.h>

#include <map>

namespace crevice {

struct KeptPrograms {
    std::map<std::string, std::vector<std::uint8_t>> entries;
    int loads = 0;   ///< Calls so far; a program that is not there counts too.
    int stores = 0;  ///< Calls so far.

    /// Must not outlive this.
    ProgramCache cache()
    {
        return {[this](const std::string& key) {
                    ++loads;
                    const auto found = entries.find(key);
                    return found == entries.end() ? std::vector<std::uint8_t>() : found->second;
                },
                [this](const std::string& key, const std::vector<std::uint8_t>& bytes) {
                    ++stores;
                    entries[key] = bytes;
                }};
    }

    GlDeviceOptions options()
    {
        GlDeviceOptions made;
        made.program_cache = cache();
        return made;
    }
};

}  // namespace crevice
