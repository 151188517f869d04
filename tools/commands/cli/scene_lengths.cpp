// SPDX-License-Identifier: MIT
#include "tools/commands/cli/scene_lengths.h"

#include <crevice/shipped.h>

#include "core/base/text.h"
#include "core/config/decode_report.h"
#include "core/config/values.h"
#include "core/json/merge.h"

namespace crevice {

void fitLengths(Description& description, const Node& document, const char* length)
{
    const auto own = [&](const std::string& pointer) {
        const Node* value = table::locate(document, pointer).node;
        const SourceRef source = value ? value->place.source : nullptr;
        const SourceRef shipped = source ? shippedSources().find(source->path) : nullptr;
        return source && !(shipped && shipped->text == source->text);
    };
    for (ParamDesc& param : description.params) {
        bool set = own("/params/" + param.name + "/default");
        for (const auto& path : levelPaths(document, param.name))
            set = set || own("/" + joined(path, "/"));
        if (!isLength(param) || set) continue;
        takeLength(length, param.value);
        param.value[3] = 8;
    }
}

}  // namespace crevice
