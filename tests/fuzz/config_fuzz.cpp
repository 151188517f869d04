// SPDX-License-Identifier: MIT
// Any text as a config over the shipped modules: merged, decoded and compiled, down to the calls of
// a recording device. What a line of "====" parts is a module that the config may extend, as
// "fuzz/base", then the config with its variant "fast", then one override.
#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include <cstdlib>

using namespace crevice;

namespace {

void expect(bool holds)
{
    if (!holds) std::abort();
}

std::vector<std::string> split(const std::string& text)
{
    const std::string line = "\n====\n";
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t at; (at = text.find(line, begin)) != text.npos; begin = at + line.size())
        parts.push_back(text.substr(begin, at - begin));
    parts.push_back(text.substr(begin));
    return parts;
}

void checkErrors(const Diagnostics& diagnostics)
{
    expect(hasErrors(diagnostics));
    expect(!toText(diagnostics).empty() && !toJson(diagnostics).empty());
}

void draw(const Description& description)
{
    RecordingDevice device;
    const Frame frame;
    auto renderer = Renderer::create(device, description, {{64, 36}, {}, {}}, traitsOf(frame));
    if (!renderer) {
        checkErrors(renderer.diagnostics());
        return expect(device.live() == 0);
    }
    const Status status = (*renderer)->render(frame);
    if (!status) checkErrors(status.diagnostics());
    expect(device.misuse().empty());
}

void check(const SourceSet& sources, const LoadRequest& request)
{
    const Result<Node> document = loadConfig(sources, request);
    if (!document) return checkErrors(document.diagnostics());
    const Result<Description> description = decode(*document, sources);
    if (!description) return checkErrors(description.diagnostics());
    draw(*description);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto parts = split(text);
    MemorySources mine;
    mine.add("configs/fuzz.json", parts.size() > 1 ? parts[1] : parts[0]);
    if (parts.size() > 1) mine.add("fuzz/base.json", parts[0]);
    const LayeredSources sources({&mine, &shippedSources()});
    LoadRequest request{"fuzz"};
    // An override may name a file of the current folder; a fuzzer must not read what it likes.
    if (parts.size() > 2 && parts[2].find("./") == std::string::npos)
        request.overrides.push_back(parts[2]);
    check(sources, request);
    if (text.find("\"fast\"") == std::string::npos) return 0;
    request.variant = "fast";
    check(sources, request);
    return 0;
}
