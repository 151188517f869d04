// SPDX-License-Identifier: MIT
// Whether shaders are right by the letter of GLSL ES, whatever the driver of this machine takes.
#pragma once

#include <crevice/compile.h>

#include <algorithm>
#include <set>

namespace crevice {

/// The warning that no shader is checked, where this build has no glslang; else nothing.
Diagnostics warnUnchecked();

/// Compiles and links programs, each that is right once.
class GlslCheck {
public:
    /// Keeps the plan's programs that were not checked yet; what is wrong with them gets a note
    /// that it was found with that, if anything.
    void add(const Plan& plan, const std::string& found_with = {});

    /// What is wrong with what was added, of plans of `description`, each mistake once: CV5001 and
    /// CV5002, at the author's file and line. What `device`, if any, says of them comes as a note.
    Diagnostics check(const Description& description, Device* device = nullptr);

private:
    struct Waiting {
        PlanProgram program;
        std::string found_with;
    };

    std::set<std::string> known_;  // keys of programs that are right or waiting
    std::vector<Waiting> waiting_;
};

/// Appends the error unless the same is there already.
inline void addOnce(Diagnostics& errors, Diagnostic error)
{
    const auto same = [&](const Diagnostic& each) {
        return each.code == error.code && each.message == error.message &&
               placeName(each.place) == placeName(error.place);
    };
    if (std::none_of(errors.begin(), errors.end(), same)) errors.push_back(std::move(error));
}

}  // namespace crevice
