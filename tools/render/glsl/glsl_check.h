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
    /// What is wrong with the programs of a plan of `description`, each mistake once: CV5001 and
    /// CV5002, at the author's file and line. What `device`, if any, says of them comes as a note.
    Diagnostics check(const Description& description, const Plan& plan, Device* device = nullptr);

private:
    std::set<std::string> right_;  // keys of programs
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
