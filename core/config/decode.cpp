// SPDX-License-Identifier: MIT
// From a merged document to a description.
#include <crevice/config.h>

#include "core/config/decode_reader.h"
#include "core/config/decode_steps.h"
#include "core/config/fields.h"

namespace crevice {

int componentCount(ParamType type)
{
    switch (type) {
    case ParamType::vec2: return 2;
    case ParamType::vec3: return 3;
    case ParamType::vec4: return 4;
    default: return 1;
    }
}

GlslType glslTypeOf(ParamType type)
{
    switch (type) {
    case ParamType::int_: return GlslType::int_;
    case ParamType::vec2: return GlslType::vec2;
    case ParamType::vec3: return GlslType::vec3;
    case ParamType::vec4: return GlslType::vec4;
    case ParamType::float_: break;
    }
    return GlslType::float_;
}

Result<Description> decode(const Node& document, const SourceSet& sources)
{
    Description description;
    description.place = document.place;
    table::Report report(!document.origins.empty());
    table::read(report, table::Cursor{document, "", document.place}, description, {});
    table::checkNames(document, description, report);
    table::checkReferences(document, sources, description, report);
    table::readShaderFiles(document, sources, description, report);
    description.deleted = table::deletedNames(document);
    Diagnostics diagnostics = report.take(document);
    if (hasErrors(diagnostics)) return diagnostics;
    description.unused = std::move(diagnostics);  // of what is left out
    for (Diagnostic& each : table::unusedNames(document, description))
        description.unused.push_back(std::move(each));
    return description;
}

}  // namespace crevice
