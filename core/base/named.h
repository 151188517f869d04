// SPDX-License-Identifier: MIT
// Things with names, and where a config names them.
#pragma once

#include "core/base/source.h"

#include <string>
#include <string_view>
#include <vector>

namespace crevice {

/// Anything a config names. `pointer` is its RFC 6901 pointer in the merged document.
struct Named {
    std::string name;
    Place place = {};
    std::string pointer = {};
};

/// The element of that name, or null.
template <class T>
const T* findNamed(const std::vector<T>& list, std::string_view name)
{
    for (const T& element : list)
        if (element.name == name) return &element;
    return nullptr;
}

/// The index of that name in a list, or -1.
template <class T>
int indexOf(const std::vector<T>& list, std::string_view name)
{
    const T* element = findNamed(list, name);
    return element ? static_cast<int>(element - list.data()) : -1;
}

/// All names of a list.
template <class T>
std::vector<std::string> namesOf(const std::vector<T>& list)
{
    std::vector<std::string> names;
    for (const T& element : list) names.push_back(element.name);
    return names;
}

}  // namespace crevice
