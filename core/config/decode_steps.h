// SPDX-License-Identifier: MIT
// The steps of `decode` after the table: names against each other, and the GLSL files. Private to
// core/decode*.cpp. They run on broken descriptions too, so that one run finds all errors; what
// an error before explains is not reported again.
#pragma once

#include "core/config/decode_report.h"

#include <set>

namespace crevice::table {

/// Reports names that collide (CV2107) and targets that follow each other's size (CV2204).
void checkNames(const Description& description, Report& report);

/// Reports what refers to nothing or stands where it may not: CV2101 to CV2106, CV2201, CV3006 and
/// CV4001. Returns all names that something refers to.
std::set<std::string> checkReferences(const Node& document, const Description& description,
                                      Report& report);

/// Reads the values under `sets` of features, of which CV2105, CV2106, CV2107, CV2204, CV4004 and
/// those of values are reported, and gives each word what any of them sets.
void readLevels(const Node& document, Description& description, Report& report);

/// Reads each GLSL file that a shader or interface names, and what it includes, into
/// `description.files`; the references become the keys there. Reports CV2104 and CV5005.
void readShaderFiles(Description& description, Report& report);

/// Errors CV2108 about params, targets and the like that the config's own file declares and nothing
/// uses, neither a reference nor GLSL; warnings where a variant or a pointer's override was laid
/// over the file. Requires the GLSL files.
Diagnostics unusedNames(const Node& document, const Description& description,
                        std::set<std::string> referred);

/// The modules of `sources` that declare a name in a section themselves, a target with its format:
/// "filter/box, filter/none" for the target "ao_filtered". Empty where none does.
std::string modulesThatDeclare(const SourceSet& sources, std::string_view section,
                               const std::string& name);

/// Those as the beginning of a help; empty where there are none.
std::string declaredBy(const SourceSet& sources, std::string_view section, const std::string& name);

}  // namespace crevice::table
