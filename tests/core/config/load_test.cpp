// SPDX-License-Identifier: MIT
// Loading configs: what they extend, and everything that can be wrong with it.
#include "tests/core/config/load_fixture.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

TEST_CASE("a place in a module leads back to the entry of the config that brought it")
{
    const Node document = loaded(smallCatalog(), {"fine"});
    const Place in_module = at(document, "passes/ssao")->place;
    CHECK(in_module.source->name == "ssao/hemisphere.json");
    CHECK(isModule(in_module));
    const Place own = ownPlace(in_module);
    CHECK(own.source->name == "configs/fine.json");
    CHECK(own.line == 1);
    CHECK(own.source->text.substr(own.column - 1, own.length) == "\"base\"");
    const Place in_config = at(document, "params/samples/default")->place;
    CHECK_FALSE(isModule(in_config));
    CHECK(ownPlace(in_config).line == in_config.line);
    CHECK(ownPlace(in_config).source == in_config.source);
}

TEST_CASE("a module reached twice is merged once, where it is met first")
{
    MemorySources sources = smallCatalog();
    sources.add("a.json", file(R"("extends": ["ssao/hemisphere"],
                                  "params": {"radius": {"default": 2}})"));
    sources.add("configs/diamond.json", file(R"("extends": ["a", "ssao/hemisphere", "a"])"));
    const Node document = loaded(sources, {"diamond"});
    CHECK(at(document, "params/radius/default")->number == 2);
    CHECK(at(document, "params/radius/default")->origins.size() == 1);
}

TEST_CASE("files on disk extend files beside them and modules of the catalog")
{
    const TemporaryFolder folder("load_disk");
    folder.write("shared.json", file(R"("extends": ["ssao/hemisphere"], "x-shared": 1)"));
    const std::string mine = folder.write(
        "sub/mine.json", file(R"("extends": ["../shared.json", "./more.json", "filter/box"])"));
    folder.write("sub/more.json", file(R"("params": {"radius": {"default": 9}})"));
    const Node document = loaded(smallCatalog(), {mine, {}, {}, {folder.path.string()}});
    CHECK(at(document, "x-shared"));
    CHECK(at(document, "passes/box"));
    const Node* radius = at(document, "params/radius/default");
    CHECK(radius->number == 9);
    CHECK(radius->place.source->name == folder.path.string() + "/sub/more.json");
    CHECK(document.place.source->name == mine);
}

TEST_CASE("a cycle on disk is found under another spelling of the path")
{
    const TemporaryFolder folder("load_cycle");
    std::filesystem::create_directories(folder.path / "sub");
    const std::string mine =
        folder.write("mine.json", file(R"("extends": ["./sub/../mine.json"])"));
    CHECK(failure(smallCatalog(), {mine}).code == Code::module_cycle);
}
