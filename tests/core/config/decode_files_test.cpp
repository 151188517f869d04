// SPDX-License-Identifier: MIT
// Decoding: the GLSL files that a config names and what they include.
#include <crevice/glsl_stage.h>

#include "tests/core/config/decode_fixture.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

namespace {

std::vector<std::string> keysOf(const Description& description)
{
    std::vector<std::string> keys;
    for (const auto& file : description.files) keys.push_back(file.first);
    return keys;
}

std::string shaders(const std::string& fragment)
{
    return R"({"ao": {"vertex": "common/fullscreen.vert", "fragment": ")" + fragment + "\"}}";
}

}  // namespace

TEST_CASE("a description carries each GLSL file that it names or includes", "[decode]")
{
    const auto result = decodeWith({});
    REQUIRE(result.ok());
    CHECK(keysOf(*result) == std::vector<std::string>{"common/fullscreen.vert", "common/view.glsl",
                                                      "geometry/a.surface.glsl",
                                                      "geometry/normal.glsl", "ssao/ao.frag"});
    for (const auto& [key, file] : result->files) CHECK(file->name == key);
    const auto stage =  // which they are enough for
        assembleStage(result->files, {{"surface", result->interfaces.at(0).file.name}},
                      result->shaders.at(0).fragment.name, {});
    INFO(toText(stage.diagnostics()));
    CHECK(stage.ok());
}

TEST_CASE("a path with ./ is relative to the file that wrote it", "[decode]")
{
    MemorySources sources = glslSources();
    sources.add("mine/local.frag", "#include \"../common/view.glsl\"\n");
    Node document = parsed(configText({{"shaders", shaders("./local.frag")}}));
    Node* fragment = document.find("shaders")->find("ao")->find("fragment");
    fragment->place.source = std::make_shared<SourceText>(
        SourceText{"effects/mine/m.json", fragment->place.source->text, "mine/m.json"});
    const auto result = decode(document, sources);
    REQUIRE(errorsOf(result) == "");
    CHECK(result->shaders.at(0).fragment.name == "mine/local.frag");
    CHECK(result->files.count("mine/local.frag") == 1);
}

TEST_CASE("a config on disk names files beside it and modules' files", "[decode]")
{
    const TemporaryFolder folder("decode_files");
    const std::string config =
        folder.write("mine/config.json", configText({{"shaders", shaders("./local.frag")}}));
    folder.write("mine/local.frag",
                 "#version 300 es\n#include \"../shared.glsl\"\n"
                 "#include \"common/view.glsl\"\n#include <surface>\n");
    folder.write("shared.glsl", "// shared\n");
    const auto roots =
        std::make_shared<std::vector<std::string>>(std::vector<std::string>{folder.path.string()});
    const auto document = parseDocument(readFile(config, roots));
    REQUIRE(document.ok());
    const auto result = decode(*document, glslSources());
    INFO(toText(result.diagnostics()));
    REQUIRE(result.ok());
    CHECK(result->shaders.at(0).fragment.name == resolvePath(config, "./local.frag"));
    CHECK(result->files.count(resolvePath(config, "../shared.glsl")) == 1);
    CHECK(result->files.count("common/view.glsl") == 1);
    CHECK(assembleStage(result->files, {{"surface", result->interfaces.at(0).file.name}},
                        result->shaders.at(0).fragment.name, {})
              .ok());
}

TEST_CASE("a missing file is an error at the path with the nearest one in the help", "[decode]")
{
    const auto result = decodeWith({{"shaders", shaders("ssao/oa.frag")}});
    REQUIRE(errorsOf(result) == "CV2104 /shaders/ao/fragment");
    CHECK_THAT(underlined(result.diagnostics()[0]), Catch::Contains("ssao/oa.frag"));
    CHECK(result.diagnostics()[0].help == "did you mean 'ssao/ao.frag'? files: ssao/ao.frag");
    checkEach({
        {"shaders", R"({"ao": {"vertex": "./no.vert", "fragment": "../../no.frag"}})",
         "CV2104 /shaders/ao/vertex; CV2104 /shaders/ao/fragment"},
        {"shaders", R"({"ao": {"vertex": "/etc/passwd", "fragment": "ssao/ao.frag"}})",
         "CV2104 /shaders/ao/vertex"},
        {"interfaces", R"({"surface": ""})", "CV2104 /interfaces/surface"},
    });
}

TEST_CASE("an interface that no module provides is reported once, with modules that do", "[decode]")
{
    MemorySources sources = glslSources();
    sources.add("ssao/two.frag", "#include <surface>\n");
    sources.add("geometry/a.json", R"({"interfaces": {"surface": "geometry/a.surface.glsl"}})");
    const auto result = decodeWith(
        {{"interfaces", ""},
         {"shaders", R"({"ao": {"vertex": "common/fullscreen.vert", "fragment": "ssao/ao.frag"},
                         "two": {"vertex": "common/fullscreen.vert",
                                 "fragment": "ssao/two.frag"}})"}},
        sources);
    REQUIRE(errorsOf(result) == "CV5005 /shaders/ao/fragment");
    CHECK(result.diagnostics()[0].help.find("geometry/a") != std::string::npos);
    REQUIRE(result.diagnostics()[0].notes.size() == 1);
    CHECK(result.diagnostics()[0].notes[0].place.source->name == "ssao/two.frag");
}

TEST_CASE("files that include each other are read once", "[decode]")
{
    MemorySources sources = glslSources();
    sources.add("ssao/ao.frag", "#include \"ssao/ao.frag\"\n#include \"./b.glsl\"\n");
    sources.add("ssao/b.glsl", "#include \"./ao.frag\"\n");
    const auto result = decodeWith({}, sources);
    REQUIRE(result.ok());
    CHECK(result->files.count("ssao/b.glsl") == 1);
}
