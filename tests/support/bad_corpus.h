// SPDX-License-Identifier: MIT
// The corpus of malformed configs in tests/data/bad, one mistake each, and the diagnostic that each
// must get. A file holds those of one kind, a case behind each line
//
//   --- NAME | CODE POINTER PLACE | part of the help | "member": of the case's options, ...
//
// PLACE is line and column in the case's own config, or another file too; "-" is none. "=== FILE"
// begins a file that a case names, and "=== around" what stands around the texts of all cases that
// follow, which take the place of its line "...".
#pragma once

#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "core/base/text.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <sstream>

namespace crevice {

struct CorpusCase {
    std::string name;  ///< "syntax/comment": the file's path without its ending.
    std::string code, pointer, at, help;
    Node options;  ///< An object: what host, device and command line are like.

    /// A text among the options; empty when it has none of that key.
    std::string text(const char* key) const
    {
        const Node* value = options.find(key);
        return value ? value->text : "";
    }
};

/// The corpus, as files below a folder that is gone with it.
class Corpus {
public:
    Corpus()
    {
        for (const char* group : {"syntax", "merge", "keys", "values", "references", "graph",
                                  "shader", "device", "run_time"})
            read(group,
                 readFile(CREVICE_SOURCE_DIR "/tests/data/bad/" + std::string(group) + ".txt")
                     ->text);
    }

    std::string folder() const { return folder_.path.string() + "/"; }
    std::string path(const CorpusCase& config) const { return folder() + config.name + ".json"; }
    const std::vector<CorpusCase>& cases() const { return cases_; }

private:
    void read(const std::string& group, const std::string& text)
    {
        std::string title, body, head, foot;
        const auto finish = [&] {
            if (title == "=== around") {
                head = body.substr(0, body.find("...\n"));
                foot = body.substr(head.size() + 4);
            } else if (startsWith(title, "=== ")) {
                folder_.write(group + "/" + title.substr(4), body);
            } else if (startsWith(title, "--- ")) {
                cases_.push_back(caseOf(group, title.substr(4)));
                body = head.empty() ? body.substr(0, body.size() - 1) : head + body + foot;
                folder_.write(cases_.back().name + ".json", body);
            }
            body.clear();
        };
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            const bool begins = startsWith(line, "--- ") || startsWith(line, "=== ");
            if (begins) finish();
            (begins ? title : body) = begins ? line : body + line + "\n";
        }
        finish();
    }

    static CorpusCase caseOf(const std::string& group, std::string title)
    {
        const auto field = [&title] {
            const std::size_t end = std::min(title.find(" | "), title.size());
            const std::string text = title.substr(0, end);
            title.erase(0, end + 3);
            return text;
        };
        CorpusCase made;
        made.name = group + "/" + field();
        std::istringstream found(field());
        found >> made.code >> made.pointer >> std::ws;
        std::getline(found, made.at);
        for (std::string* each : {&made.pointer, &made.at})
            if (*each == "-") each->clear();
        if (!made.at.empty() && isDigit(made.at[0])) made.at = made.name + ".json:" + made.at;
        made.help = field();
        const Result<Node> options =
            parseDocument(std::make_shared<SourceText>(SourceText{made.name, "{" + title + "}"}));
        if (!options) FAIL(toText(options.diagnostics()));
        made.options = *options;
        return made;
    }

    TemporaryFolder folder_{"bad_configs"};
    std::vector<CorpusCase> cases_;
};

inline const Corpus& corpus()
{
    static const Corpus all;
    return all;
}

/// A device of the least abilities, with those changed that the case names.
inline DeviceCaps capsOf(const CorpusCase& config)
{
    DeviceCaps caps = config.options.find("device") ? minimumCaps() : generousCaps();
    if (const Node* vectors = config.options.find("max_fragment_uniform_vectors"))
        caps.max_fragment_uniform_vectors = static_cast<int>(vectors->number);
    return caps;
}

inline LoadRequest requestOf(const CorpusCase& config)
{
    LoadRequest request{corpus().path(config), config.text("variant")};
    if (const Node* overrides = config.options.find("set"))
        for (const Node& each : overrides->items) request.overrides.push_back(each.text);
    if (config.options.find("catalog")) request.config = "given";
    return request;
}

/// What the host does once there is a renderer: sets what the case says, and draws.
inline Diagnostics runTimeErrors(const CorpusCase& config, Renderer& renderer)
{
    if (const Node* host = config.options.find("host")) {
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
    if (config.options.find("catalog"))
        mine.add("configs/given.json", readFile(corpus().path(config))->text);
    const LayeredSources sources({&mine, &shippedSources()});
    const Result<Node> document = loadConfig(sources, requestOf(config));
    if (!document) return document.diagnostics();
    const Result<Description> description = decode(*document, sources);
    if (!description) return description.diagnostics();
    CompileOptions options{{256, 144}, {}, {}};
    if (const Node* side = config.options.find("side"))
        options.extent = {static_cast<int>(side->number), static_cast<int>(side->number)};
    if (const Node* outputs = config.options.find("outputs"))
        options.outputs.push_back(outputs->text);
    auto renderer = Renderer::create(device, *description, options, traitsOf({}));
    return renderer ? runTimeErrors(config, **renderer) : renderer.diagnostics();
}

/// "my.json:4:29" with the folder of the corpus left out.
inline std::string placeInCorpus(const Place& place)
{
    std::string name = placeName(place);
    const std::string folder = corpus().folder();
    const std::size_t at = name.find(folder);
    return at == std::string::npos ? name : name.substr(at + folder.size());
}

/// What a config's one error must have.
inline void checkReported(const CorpusCase& config, const Diagnostics& reported)
{
    INFO(config.name << "\n" << toText(reported));
    REQUIRE(reported.size() == 1);
    CHECK(codeName(reported[0].code) == config.code);
    CHECK(placeInCorpus(reported[0].place) == config.at);
    CHECK(reported[0].pointer == config.pointer);
    CHECK_THAT(reported[0].help, Catch::Contains(config.help));
}

}  // namespace crevice
