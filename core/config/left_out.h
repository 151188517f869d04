// SPDX-License-Identifier: MIT
// Files of a config that another takes the place of.
#pragma once

#include <crevice/document.h>

#include <set>

namespace crevice {

/// A file of a config as it was read, what is not merged taken out of its body. Its place is where
/// it was asked for: nowhere for the config itself.
struct LoadedFile : Named {
    std::string identity = {};  ///< The same by whatever path the file was reached.
    Node body = {};
    std::vector<Member> variants = {};
    std::vector<std::string> needs = {};
    std::vector<std::string> replaces = {};
    std::set<std::string> extended = {};  ///< Identities, by whatever way.
    int named = 0;                        ///< When it was named last; what is named later has more.
};

/// Sections, each with the name of something that stands in it.
using Names = std::set<std::pair<std::string, std::string>>;

/// Adds what the file declares, or with `all` everything that it speaks of.
void collectNames(const Node& body, bool all, Names& names);

/// The first interface or shader that both files make, or nothing.
std::optional<std::string> madeByBoth(const Node& one, const Node& other);

/// CV1208 of two files that make the same, the last that were read: others often are extended.
std::optional<Diagnostic> clashIn(const std::vector<LoadedFile>& files);

/// What was left out of a config.
struct Removal {
    std::vector<Member> files = {};  ///< Names of files, and strings that say why.
    Names names = {};                ///< What no file declares any more.
    Place place = {};                ///< Where the last file was asked for that replaced another.
};

/// Takes out of `files`, which are in the order of merging, each that needs what another replaces
/// which is named later and which it does not extend. Of the files before that one it takes what
/// they say of params, passes and so on that only left out files declare.
Removal leaveOutReplaced(std::vector<LoadedFile>& files);

}  // namespace crevice
