// SPDX-License-Identifier: MIT
// Files of a config that another takes the place of.
#pragma once

#include <crevice/document.h>

#include <set>
#include <string>
#include <vector>

namespace crevice {

/// Where a file was asked for: nowhere for the config itself.
struct Asked {
    Place place = {};
    std::string pointer = {};
};

/// A file of a config as it was read, what is not merged taken out of its body.
struct LoadedFile {
    std::string identity;  ///< What distinguishes two files, by whatever path they were reached.
    std::string name;
    Asked asked = {};
    Node body = {};
    std::vector<Member> variants = {};
    std::vector<std::string> needs = {};
    std::vector<std::string> replaces = {};
    std::set<std::string> extended = {};  ///< Identities, by whatever way.
    int named = 0;                        ///< When it was named last; what is named later has more.
};

/// Takes out of `files`, which are in the order of merging, each that needs what another replaces
/// which is named later and which it does not extend. Of the files before that one it takes what
/// they say of params, passes and so on that only left out files declare.
///
/// What comes back is for the notes and reasons of the merged document: at the top a member by the
/// name of each left out file, whose text is the reason; below a section a null for each name that
/// is declared no longer. Keys have the place where the file was asked for that replaces theirs.
Node leaveOutReplaced(std::vector<LoadedFile>& files);

}  // namespace crevice
