// SPDX-License-Identifier: MIT
#include "core/config/joined_name.h"

#include "core/base/text.h"

namespace crevice {

std::vector<std::string> splitName(const std::string& name)
{
    constexpr std::string_view kFile = ".json";
    if (endsWith(name, kFile) || startsWith(name, "{")) return {name};
    const std::size_t file = name.rfind(std::string(kFile) + "+");
    std::size_t end = name.find('+', file == std::string::npos ? 0 : file);
    std::vector<std::string> parts = {name.substr(0, end)};
    while (end != std::string::npos) {
        const std::size_t begin = end + 1;
        end = name.find('+', begin);
        parts.push_back(name.substr(begin, end - begin));
    }
    return parts;
}

}  // namespace crevice
