// SPDX-License-Identifier: MIT
// The corpus of malformed configs in tests/data/bad, one mistake each, and the diagnostic that each
// must get. tests/data/bad/README.md describes expected.json, from which all of this is read.
#pragma once

#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tests/support/catch.h"

#include <string>
#include <vector>

namespace crevice {

struct CorpusCase {
    std::string name;  ///< "syntax/comment": the file's path without its ending.
    Node expected;     ///< Its entry in expected.json.

    std::string path() const { return folder() + name + ".json"; }
    static std::string folder() { return CREVICE_SOURCE_DIR "/tests/data/bad/"; }

    /// A text of the entry; empty when it has none of that key.
    std::string text(const char* key) const
    {
        const Node* value = expected.find(key);
        return value ? value->text : "";
    }
};

/// All of expected.json, in its order.
inline std::vector<CorpusCase> corpusCases()
{
    const Result<Node> table = parseDocument(readFile(CorpusCase::folder() + "expected.json"));
    if (!table) FAIL(toText(table.diagnostics()));
    std::vector<CorpusCase> configs;
    for (const Member& group : table->members)
        for (const Member& entry : group.value.members)
            configs.push_back({group.key + "/" + entry.key, entry.value});
    return configs;
}

/// A device of the least abilities, with those changed that the entry names.
inline DeviceCaps capsOf(const CorpusCase& config)
{
    DeviceCaps caps = config.expected.find("device") ? minimumCaps() : generousCaps();
    if (const Node* vectors = config.expected.find("max_fragment_uniform_vectors"))
        caps.max_fragment_uniform_vectors = static_cast<int>(vectors->number);
    return caps;
}

inline LoadRequest requestOf(const CorpusCase& config)
{
    LoadRequest request{config.path(), config.text("variant")};
    if (const Node* overrides = config.expected.find("set"))
        for (const Node& each : overrides->items) request.overrides.push_back(each.text);
    if (config.expected.find("catalog")) request.config = "given";
    return request;
}

/// What the host does once there is a renderer: sets what the entry says, and draws.
inline Diagnostics runTimeErrors(const CorpusCase& config, Renderer& renderer)
{
    if (const Node* host = config.expected.find("host")) {
        const Member& member = host->members.at(0);
        const float value = static_cast<float>(member.value.number);
        const bool word = member.value.kind == Node::Kind::string;
        return (word ? renderer.setFeature(member.key, member.value.text)
                     : renderer.setParam(member.key, &value, 1))
            .diagnostics();
    }
    return renderer.render({}).diagnostics();
}

/// All diagnostics of the config, from reading it to its first frame, on that device.
inline Diagnostics diagnosticsOf(const CorpusCase& config, Device& device)
{
    MemorySources mine;
    if (config.expected.find("catalog"))
        mine.add("configs/given.json", readFile(config.path())->text);
    const LayeredSources sources({&mine, &shippedSources()});
    const Result<Node> document = loadConfig(sources, requestOf(config));
    if (!document) return document.diagnostics();
    const Result<Description> description = decode(*document, sources);
    if (!description) return description.diagnostics();
    CompileOptions options{{256, 144}, {}, {}};
    if (const Node* side = config.expected.find("side"))
        options.extent = {static_cast<int>(side->number), static_cast<int>(side->number)};
    if (const Node* outputs = config.expected.find("outputs"))
        options.outputs.push_back(outputs->text);
    auto renderer = Renderer::create(device, *description, options, traitsOf({}));
    return renderer ? runTimeErrors(config, **renderer) : renderer.diagnostics();
}

/// "my.json:4:29" with the folder of the corpus left out.
inline std::string placeInCorpus(const Place& place)
{
    std::string name = placeName(place);
    const std::string folder = CorpusCase::folder();
    const std::size_t at = name.find(folder);
    return at == std::string::npos ? name : name.substr(at + folder.size());
}

/// What a config's one error must have.
inline void checkReported(const CorpusCase& config, const Diagnostics& reported)
{
    INFO(config.name << "\n" << toText(reported));
    REQUIRE(reported.size() == 1);
    CHECK(codeName(reported[0].code) == config.text("code"));
    CHECK(placeInCorpus(reported[0].place) == config.text("at"));
    CHECK(reported[0].pointer == config.text("pointer"));
    CHECK_THAT(reported[0].help, Catch::Contains(config.text("help")));
}

}  // namespace crevice
