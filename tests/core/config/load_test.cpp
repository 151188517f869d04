// SPDX-License-Identifier: MIT
// Loading configs: what they extend, and everything that can be wrong with it.
#include "tests/core/config/load_fixture.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

TEST_CASE("a config is merged over what it extends, from left to right")
{
    const Node document = loaded(smallCatalog(), {"base"});
    CHECK(at(document, "targets/depth"));
    CHECK(at(document, "passes/ssao"));
    CHECK(at(document, "passes/box"));
    CHECK(at(document, "name")->text == "base");
    CHECK(at(document, "format")->number == 1);
    CHECK_FALSE(at(document, "extends"));
    CHECK_FALSE(at(document, "variants"));
}

TEST_CASE("a config may extend a config and change it")
{
    const Node document = loaded(smallCatalog(), {"fine"});
    const Node* samples = at(document, "params/samples/default");
    CHECK(samples->number == 64);
    CHECK(samples->place.source->name == "configs/fine.json");
    REQUIRE(samples->origins.size() == 1);
    CHECK(samples->origins[0].source->name == "ssao/hemisphere.json");
    CHECK(at(document, "name")->text == "fine");
    CHECK(document.place.source->name == "configs/fine.json");
}

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

TEST_CASE("relative names are seen from the file that writes them")
{
    MemorySources sources = smallCatalog();
    sources.add("configs/parts/a.json", file(R"("extends": ["../../filter/box.json"], "x-a": 1)"));
    sources.add("configs/whole.json", file(R"("extends": ["./parts/a.json"])"));
    const Node document = loaded(sources, {"whole"});
    CHECK(at(document, "x-a"));
    CHECK(at(document, "passes/box"));
}

TEST_CASE("a path that climbs out of the catalog is an error, even when a file lies there")
{
    const Diagnostic error = failureOf(file(R"("extends": ["../../../etc/passwd.json"])"));
    CHECK(error.code == Code::module_escape);
    CHECK(placeName(error.place) == "configs/bad.json:1:27");
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

TEST_CASE("a path in the working folder needs no './' and may climb to a root")
{
    const TemporaryFolder folder("load_working");
    folder.write("up.json", file(R"("x-up": 1)"));
    folder.write("work/mine.json", file(R"("extends": ["../up.json"])"));
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path / "work");
    const Result<Node> document = loadConfig(smallCatalog(), {"mine.json", {}, {}, {".."}});
    std::filesystem::current_path(before);
    REQUIRE(document);
    CHECK(document->place.source->name == "mine.json");
    CHECK(at(*document, "x-up"));
}

TEST_CASE("a catalog path may be named where no file on disk has it")
{
    const TemporaryFolder folder("load_hidden");
    const std::string mine = folder.write("mine.json", file(R"("name": "mine")"));
    MemorySources sources = smallCatalog();
    sources.add(mine, file(R"("name": "hidden")"));
    CHECK(at(loaded(sources, {mine}), "name")->text == "mine");
    CHECK(at(loaded(sources, {"configs/fine.json"}), "name")->text == "fine");
}

TEST_CASE("a config that does not exist is an error with the nearest names")
{
    const Diagnostic error = failure(smallCatalog(), {"fin"});
    CHECK(error.code == Code::module_missing);
    CHECK_THAT(error.help, Catch::Contains("did you mean 'fine'? shipped configs: base, fine"));
    CHECK(failure(smallCatalog(), {""}).code == Code::module_missing);
    CHECK(failure(smallCatalog(), {"../configs/fine"}).code == Code::module_missing);
}

TEST_CASE("a config file that is missing is distinguished from one that cannot be read")
{
    const TemporaryFolder folder("load_unreadable");
    std::filesystem::create_directories(folder.path / "folder.json");
    const Diagnostic missing = failure(smallCatalog(), {(folder.path / "none.json").string()});
    CHECK(missing.code == Code::module_missing);
    CHECK_THAT(missing.message, Catch::Contains("does not exist"));
    const Diagnostic unread = failure(smallCatalog(), {(folder.path / "folder.json").string()});
    CHECK(unread.code == Code::module_missing);
    CHECK_THAT(unread.message, Catch::Contains("cannot be read"));
}

TEST_CASE("a missing module is one error at its name, whatever else hangs on it")
{
    const Diagnostic error =
        failureOf(file(R"("extends": ["filter/bax"], "passes": {"box": null})"));
    CHECK(error.code == Code::module_missing);
    CHECK(placeName(error.place) == "configs/bad.json:1:27");
    CHECK(error.place.length == 12);
    CHECK_THAT(error.help, Catch::Contains("did you mean 'filter/box'?"));
    const Diagnostic path = failureOf(file(R"("extends": ["./none.json"])"));
    CHECK(path.code == Code::module_missing);
    CHECK_THAT(path.message, Catch::Contains("configs/none.json"));
    CHECK_THAT(failureOf(file(R"("extends": ["mine.json"])")).help, Catch::Contains("'./'"));
}

TEST_CASE("a cycle prints its chain")
{
    MemorySources sources;
    sources.add("configs/a.json", file(R"("extends": ["b"])"));
    sources.add("b.json", file(R"("extends": ["c"])"));
    sources.add("c.json", file(R"("extends": ["b"])"));
    const Diagnostic error = failure(sources, {"a"});
    CHECK(error.code == Code::module_cycle);
    CHECK_THAT(error.message, Catch::Contains("b.json -> c.json -> b.json"));
    CHECK(placeName(error.place) == "c.json:1:27");
}

TEST_CASE("a cycle on disk is found under another spelling of the path")
{
    const TemporaryFolder folder("load_cycle");
    std::filesystem::create_directories(folder.path / "sub");
    const std::string mine =
        folder.write("mine.json", file(R"("extends": ["./sub/../mine.json"])"));
    CHECK(failure(smallCatalog(), {mine}).code == Code::module_cycle);
}

TEST_CASE("extends ends at eight levels")
{
    MemorySources sources;
    for (int i = 0; i < 10; ++i)
        sources.add(std::to_string(i) + ".json",
                    file("\"extends\": [\"" + std::to_string(i + 1) + "\"]"));
    sources.add("10.json", file(""));
    sources.add("configs/eight.json", file(R"("extends": ["3"])"));  // 3 to 10 are eight
    sources.add("configs/nine.json", file(R"("extends": ["2"])"));
    loaded(sources, {"eight"});
    CHECK(failure(sources, {"nine"}).code == Code::module_depth);
}

TEST_CASE("every file says that its format is 1")
{
    for (const char* wrong : {"0", "-1", "1.0", "1.5", "true", "null", "[1]"}) {
        const std::string text = std::string("{\"format\": ") + wrong + "}";
        CHECK(failureOf(text).code == Code::format_version);
    }
    MemorySources sources = smallCatalog();
    sources.add("filter/box.json", "{}");
    CHECK(placeName(failure(sources, {"base"}).place) == "filter/box.json:1:1");
    CHECK(failureOf(file(R"("extends": null)")).code == Code::wrong_type);
}

TEST_CASE("the errors of all files are reported together")
{
    MemorySources sources = smallCatalog();
    sources.add("filter/box.json", "{\"format\": 1;}");
    sources.add("configs/bad.json", file(R"("extends": ["filter/box", "none", 3])"));
    CHECK(loadConfig(sources, {"bad"}).diagnostics().size() == 3);
}

TEST_CASE("the configs of a catalog are listed by name")
{
    CHECK(configNames(smallCatalog()) == std::vector<std::string>{"base", "fine"});
    CHECK(configNames(MemorySources()).empty());
}

TEST_CASE("the schema that a file names for editors is no part of the config")
{
    MemorySources sources = smallCatalog();
    sources.add("ssao/hemisphere.json", file(R"("$schema": "../schema.json")"));
    sources.add("configs/fine.json",
                file(R"("$schema": "schema.json", "extends": ["ssao/hemisphere"])"));
    CHECK(at(loaded(sources, {"fine"}), "$schema") == nullptr);
}
