// SPDX-License-Identifier: MIT
// The source tree as a test: who may include whom, where GL may be named, licences, test names.
#include "tests/support/catch.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"core", {"core"}},
    {"backends", {"backends", "core"}},
    {"effects", {"effects", "core"}},
    {"effects/c_api", {"effects", "core", "backends"}},
    {"tools", {"tools", "core", "backends", "effects"}},
    {"tests", {"tests", "tools", "core", "backends", "effects"}},
};

// The rooms of a library from the bottom up: a file may include its own room and those before it.
const std::map<std::string, std::vector<std::string>> kRooms = {
    {"core",
     {"base", "json", "glsl", "sampling", "gpu", "frame", "config", "plan", "compile", "run",
      "renderer"}},
    {"backends", {"gl", "context", "recording"}},
    {"tools",
     {"image", "cli", "schema", "plan", "scene", "reference", "device", "render", "cost", "motion",
      "measure", "bench", "stress", "report", "view", "commands", "examples"}},
};

std::string readText(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Files below the project's own folders, as paths relative to the checkout.
std::vector<fs::path> projectFiles(const std::set<std::string>& folders)
{
    const fs::path root = CREVICE_SOURCE_DIR;
    std::vector<fs::path> files;
    for (const std::string& folder : folders) {
        if (!fs::is_directory(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root));
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool isCpp(const fs::path& path) { return path.extension() == ".h" || path.extension() == ".cpp"; }

/// The folder of the checkout that a file belongs to.
std::string topFolder(const fs::path& path) { return path.begin()->string(); }

/// Whose includes a file may have: its top folder's, but for the one place that knows effects and
/// backends both.
std::string libraryOf(const fs::path& path)
{
    const bool c_api = path.string().rfind("effects/c_api/", 0) == 0;
    return c_api ? "effects/c_api" : topFolder(path);
}

/// An application that uses crevice, as a reader's would: it prints, and calls GL.
bool isExample(const fs::path& path) { return path.string().rfind("tools/examples/", 0) == 0; }

/// The code without comments, and without the content of string literals if `strings` is false.
std::string codeOf(const std::string& text, bool strings)
{
    static const std::regex kTokens(R"re(//[^\n]*|/\*[^]*?\*/|"(?:\\.|[^"\\\n])*")re");
    std::string code;
    auto last = text.begin();
    const std::sregex_iterator end;
    for (std::sregex_iterator match(text.begin(), text.end(), kTokens); match != end; ++match) {
        code.append(last, (*match)[0].first);
        if (strings && *(*match)[0].first == '"') code += match->str();
        last = (*match)[0].second;
    }
    return code.append(last, text.end());
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern, int group)
{
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
        found.push_back(match->str(group));
    return found;
}

/// The project's files that the text includes, as paths relative to the checkout: of "core/x.h"
/// that, of <crevice/x.h> the public header in its library.
std::vector<std::string> includesOf(const std::string& text)
{
    const std::string code = codeOf(text, true);
    std::vector<std::string> paths = matches(code, R"re((?:^|\n)\s*#\s*include "([^"]+)")re", 1);
    for (const std::string& name :
         matches(code, R"re((?:^|\n)\s*#\s*include <crevice/([^>]+)>)re", 1))
        for (const char* library : {"core", "backends", "effects", "effects/c_api"}) {
            const std::string path = std::string(library) + "/include/crevice/" + name;
            if (fs::exists(fs::path(CREVICE_SOURCE_DIR) / path)) paths.push_back(path);
        }
    return paths;
}

/// Includes of a file in `folder` that point sideways or upwards.
std::vector<std::string> wrongIncludes(const std::string& folder, const std::string& text)
{
    std::vector<std::string> wrong;
    for (const std::string& include : includesOf(text)) {
        const std::string target = include.substr(0, include.find('/'));
        if (!kMayInclude.at(folder).count(target)) wrong.push_back(include);
    }
    return wrong;
}

/// Includes of an example that are neither public headers nor files of the examples.
std::vector<std::string> privateIncludes(const fs::path& example, const std::string& text)
{
    std::vector<std::string> found;
    for (const std::string& include :
         matches(codeOf(text, true), R"re((?:^|\n)\s*#\s*include "([^"]+)")re", 1))
        if (!isExample(include) &&
            !fs::exists(fs::path(CREVICE_SOURCE_DIR) / example.parent_path() / include))
            found.push_back(include);
    return found;
}

/// The place among the library's rooms of the room that a file is in. A public header belongs to
/// the room of the source that includes it first, as its own header; without one, to the highest
/// that it includes.
std::size_t tierOf(const std::string& library, const std::string& path)
{
    const std::vector<std::string>& rooms = kRooms.at(library);
    const std::string room = *std::next(fs::path(path).begin());
    if (room != "include")
        return static_cast<std::size_t>(std::find(rooms.begin(), rooms.end(), room) -
                                        rooms.begin());
    for (const fs::path& source : projectFiles({library})) {
        if (source.extension() != ".cpp") continue;
        const std::string text = readText(fs::path(CREVICE_SOURCE_DIR) / source);
        const std::string first = "#include <crevice/" + fs::path(path).filename().string() + ">";
        if (text.find("#include") == text.find(first)) return tierOf(library, source.string());
    }
    std::size_t tier = 0;
    for (const std::string& include : includesOf(readText(fs::path(CREVICE_SOURCE_DIR) / path)))
        if (include.rfind(library + "/", 0) == 0) tier = std::max(tier, tierOf(library, include));
    return tier;
}

/// Includes of a text at that tier that climb to a later room of its library, or to none.
std::vector<std::string> climbingIncludes(const std::string& library, std::size_t tier,
                                          const std::string& text)
{
    std::vector<std::string> wrong;
    for (const std::string& path : includesOf(text))
        if (path.rfind(library + "/", 0) == 0 && tierOf(library, path) > tier)
            wrong.push_back(path);
    return wrong;
}

/// Adds the file, as a path relative to the checkout, and all of the project that it includes,
/// through others too.
void addIncluded(const std::string& path, std::set<std::string>& files)
{
    if (!files.insert(path).second) return;
    const std::string text = readText(fs::path(CREVICE_SOURCE_DIR) / path);
    for (const std::string& include : includesOf(text)) addIncluded(include, files);
}

/// Files of the config language and of JSON that the file includes, through others too.
std::vector<std::string> configIncludes(const std::string& path)
{
    std::set<std::string> files;
    addIncluded(path, files);
    std::vector<std::string> found;
    for (const std::string& file : files)
        if (tierOf("core", file) == tierOf("core", "core/config/x") ||
            tierOf("core", file) == tierOf("core", "core/json/x"))
            found.push_back(file);
    return found;
}

std::vector<std::string> graphicsHeaders(const std::string& text)
{
    return matches(text, R"re((?:^|\n)\s*#\s*include [<"]((?:GL\w*|EGL|KHR)/[^>"]+))re", 1);
}

/// GL, EGL and OSMesa functions, types and constants. GLSL's own gl_ names are none.
std::vector<std::string> graphicsNames(const std::string& text)
{
    return matches(codeOf(text, false),
                   R"re(\b(gl[A-Z]\w+|egl[A-Z]\w+|OSMesa[A-Z]\w*|E?GL_[A-Z]\w+|)re"
                   R"re(GL(?:u?int|enum|float|sizei|boolean|bitfield)|EGL(?:Display|Context)))re"
                   R"re((?=\s*\(|\b))re",
                   0);
}

/// What formats or parses numbers by the host's locale: floats in printf and scanf, strtod and its
/// kin, string streams.
std::vector<std::string> numbersByLocale(const std::string& text)
{
    const std::string code = codeOf(text, true);
    std::vector<std::string> found = matches(
        code, R"re(\b(?:strto(?:f|d|ld)|atof|sto(?:f|d|ld)|set(?:locale|precision))\s*\()re", 0);
    for (const char* pattern : {R"re("[^"\n]*%[-+#0-9.*]*l?[aAeEfFgG][^"\n]*")re",
                                R"re(\b[io]?stringstream\b|\bstd::c(?:out|err)\b)re"})
        for (std::string& match : matches(code, pattern, 0)) found.push_back(std::move(match));
    return found;
}

const std::string kPrints =
    R"re(\b(?:v?f?printf|f?puts|f?putc|putchar|cout|cerr|clog|stdout|stderr)\b)re";
const std::string kOpens = R"re(\b(?:[io]?fstream|fopen|freopen|fdopen)\b)re";

std::string firstLines(const std::string& text, int count)
{
    std::size_t end = 0;
    for (int line = 0; line < count && end != std::string::npos; ++line)
        end = text.find('\n', end == 0 ? 0 : end + 1);
    return text.substr(0, end);
}

std::vector<std::string> configStems()
{
    std::vector<std::string> stems;
    for (const fs::path& path : projectFiles({"configs"}))
        if (path.extension() == ".json") stems.push_back(path.stem().string());
    return stems;
}

}  // namespace

TEST_CASE("the include check finds an include that points sideways or upwards")
{
    CHECK(wrongIncludes("core", "#include \"core/plan/plan.h\"\n#include <vector>\n").empty());
    CHECK(wrongIncludes("core", "#include \"backends/context/context.h\"\n").size() == 1);
    CHECK(wrongIncludes("effects", "#include \"backends/context/context.h\"\n").size() == 1);
    CHECK(wrongIncludes("backends", "#include \"effects/catalog.h\"\n").size() == 1);
    CHECK(wrongIncludes("effects", "#include <crevice/gl_device.h>\n").size() == 1);
    CHECK(wrongIncludes("effects/c_api", "#include <crevice/gl_device.h>\n").empty());
    CHECK(wrongIncludes("effects/c_api", "#include \"tools/image/image_file.h\"\n").size() == 1);
    CHECK(wrongIncludes("core", "#include \"plan.h\"\n").size() == 1);
    CHECK(wrongIncludes("core", "// #include \"tools/scene/scene.h\"\n").empty());
    CHECK(graphicsHeaders("#include <GLES3/gl3.h>\n").size() == 1);
    CHECK(graphicsNames("glClear(GL_COLOR_BUFFER_BIT); GLuint name; gl_VertexID;").size() == 3);
    CHECK(graphicsNames("// glClear\nconst char* text = \"GL_ES\";").empty());
}

TEST_CASE("includes point downwards only")
{
    int files = 0;
    for (const fs::path& path : projectFiles({"core", "backends", "effects", "tools", "tests"})) {
        if (!isCpp(path) || path.string().rfind("tests/outside/", 0) == 0 || isExample(path))
            continue;
        ++files;
        for (const std::string& include :
             wrongIncludes(libraryOf(path), readText(fs::path(CREVICE_SOURCE_DIR) / path)))
            FAIL_CHECK(path.string() << " includes " << include);
    }
    CHECK(files > 30);
}

TEST_CASE("examples include public headers and one another alone, and are at most 120 lines long")
{
    int examples = 0;
    for (const fs::path& path : projectFiles({"tools"})) {
        if (!isExample(path) || path.filename() == "CMakeLists.txt") continue;
        ++examples;
        INFO(path.string());
        const std::string text = readText(fs::path(CREVICE_SOURCE_DIR) / path);
        CHECK(std::count(text.begin(), text.end(), '\n') <= 120);
        CHECK(privateIncludes(path, text).empty());
    }
    CHECK(privateIncludes("tools/examples/a.cpp", "#include \"core/base/text.h\"\n").size() == 1);
    CHECK(examples >= 2);
}

TEST_CASE("the tier check finds an include that climbs to a later room")
{
    const auto climbs = [](const std::string& from, const std::string& include) {
        return climbingIncludes("core", tierOf("core", from), "#include " + include + "\n").size();
    };
    CHECK(climbs("core/plan/x.cpp", "\"core/config/fields.h\"") == 0);
    CHECK(climbs("core/plan/x.cpp", "<crevice/plan.h>") == 0);
    CHECK(climbs("core/plan/x.cpp", "\"core/compile/steps.h\"") == 1);
    CHECK(climbs("core/base/x.cpp", "<crevice/document.h>") == 1);
    CHECK(climbs("core/run/x.cpp", "<crevice/renderer.h>") == 1);
    CHECK(climbs("core/run/x.cpp", "\"core/renderer.h\"") == 1);
    CHECK(climbs("core/gpu/x.cpp", "<crevice/config.h>") == 1);
    CHECK(climbs("core/run/x.cpp", "<crevice/device.h>") == 0);
}

TEST_CASE("the rooms of a library include downwards only")
{
    std::map<std::string, std::set<std::size_t>> found;
    for (const fs::path& path : projectFiles({"core", "backends", "tools"})) {
        if (!isCpp(path)) continue;
        INFO(path.string());
        const std::string library = topFolder(path);
        const std::size_t tier = tierOf(library, path.string());
        CHECK(tier < kRooms.at(library).size());
        found[library].insert(tier);
        for (const std::string& include :
             climbingIncludes(library, tier, readText(fs::path(CREVICE_SOURCE_DIR) / path)))
            FAIL_CHECK(path.string() << " includes " << include);
    }
    for (const auto& [library, rooms] : kRooms) CHECK(found[library].size() == rooms.size());
}

TEST_CASE("no source folder has more than 25 files")
{
    std::map<fs::path, int> files;
    for (const fs::path& path : projectFiles({"core", "backends", "effects", "tools", "tests"}))
        if (path.string().rfind("tests/data/", 0) != 0 &&
            path.string().rfind("tests/fuzz/seeds", 0) != 0)
            ++files[path.parent_path()];
    for (const auto& [folder, count] : files) {
        INFO(folder << " has " << count << " files");
        CHECK(count <= 25);
    }
}

TEST_CASE("what runs a plan knows no config and no JSON")
{
    CHECK_FALSE(configIncludes("core/include/crevice/renderer.h").empty());
    CHECK(configIncludes("core/include/crevice/plan.h").empty());
    for (const fs::path& path : projectFiles({"core"})) {
        const std::string room = std::next(path.begin())->string();
        if (!isCpp(path) || (room != "run" && room != "gpu")) continue;
        for (const std::string& found : configIncludes(path.string()))
            FAIL_CHECK(path.string() << " includes " << found << ", by itself or through others");
    }
}

TEST_CASE("graphics headers are included in backends alone")
{
    for (const fs::path& path : projectFiles({"core", "effects", "tools", "tests"})) {
        if (!isCpp(path) || isExample(path)) continue;
        for (const std::string& header :
             graphicsHeaders(readText(fs::path(CREVICE_SOURCE_DIR) / path)))
            FAIL_CHECK(path.string() << " includes " << header);
    }
}

TEST_CASE("the number check finds what a locale changes")
{
    CHECK(numbersByLocale("printf(\"%5.2f ms\", ms);").size() == 1);
    CHECK(numbersByLocale("snprintf(text, 9, \"vec2(%.3e\", x);").size() == 1);
    CHECK(numbersByLocale("sscanf(text, \"%d %lf\", &n, &x);").size() == 1);
    CHECK(numbersByLocale("std::strtod(text, nullptr); std::stof(text);").size() == 2);
    CHECK(numbersByLocale("std::ostringstream out;").size() == 1);
    CHECK(numbersByLocale("printf(\"%d of %-5s, %04x, 100 %% of\", n, text, bits);").empty());
    CHECK(numbersByLocale("// printf(\"%f\")\nrestored(text);").empty());
}

TEST_CASE("numbers are formatted and parsed in core/base/numbers alone")
{
    for (const fs::path& path : projectFiles({"core", "backends", "effects", "tools"})) {
        if (!isCpp(path) || isExample(path)) continue;
        for (const std::string& found :
             numbersByLocale(readText(fs::path(CREVICE_SOURCE_DIR) / path)))
            FAIL_CHECK(path.string()
                       << " has " << found << ": use core/base/numbers.h, which knows no locale");
    }
}

TEST_CASE("core, effects and tools name nothing of GL")
{
    for (const fs::path& path : projectFiles({"core", "effects", "tools"})) {
        if (!isCpp(path) || isExample(path)) continue;
        for (const std::string& name : graphicsNames(readText(fs::path(CREVICE_SOURCE_DIR) / path)))
            FAIL_CHECK(path.string() << " names " << name);
    }
}

TEST_CASE("text is printed in one place, which keeps control characters off the terminal")
{
    for (const fs::path& path : projectFiles({"core", "backends", "effects", "tools"})) {
        if (!isCpp(path) || isExample(path) ||
            path.parent_path() / path.stem() == "tools/cli/output")
            continue;
        const std::string code = codeOf(readText(fs::path(CREVICE_SOURCE_DIR) / path), false);
        for (const std::string& name : matches(code, kPrints, 0))
            FAIL_CHECK(path.string() << " prints by " << name);
    }
    const std::string some = "std::printf(x); std::fputs(x, stderr); std::snprintf(x);";
    CHECK(matches(some, kPrints, 0).size() == 3);
}

TEST_CASE("files are opened where pipes, devices and endless files are refused")
{
    static const std::set<fs::path> kOpen = {"core/base/files.cpp", "tools/image/image_file.cpp",
                                             "tools/measure/line_file.cpp"};
    for (const fs::path& path : projectFiles({"core", "backends", "effects", "tools"})) {
        if (!isCpp(path) || kOpen.count(path) > 0) continue;
        const std::string code = codeOf(readText(fs::path(CREVICE_SOURCE_DIR) / path), false);
        for (const std::string& name : matches(code, kOpens, 0))
            FAIL_CHECK(path.string() << " opens files by " << name);
    }
    CHECK(matches("std::ifstream file(path); fopen(path);", kOpens, 0).size() == 2);
}

TEST_CASE("no library source names a config")
{
    const std::vector<std::string> configs = configStems();
    CHECK(configs.size() >= 3);
    for (const fs::path& path : projectFiles({"core", "backends", "effects"})) {
        if (!isCpp(path)) continue;
        const std::string code = codeOf(readText(fs::path(CREVICE_SOURCE_DIR) / path), true);
        for (const std::string& config : configs) {
            INFO(path.string() << " names the config " << config);
            CHECK(code.find('"' + config + '"') == std::string::npos);
            CHECK(code.find(config + ".json") == std::string::npos);
        }
    }
}

TEST_CASE("every source file carries the licence line")
{
    static const std::set<std::string> kKinds = {".h",    ".c",    ".cpp",  ".cmake", ".sh",
                                                 ".frag", ".vert", ".glsl", ".comp",  ".in"};
    for (const fs::path& path :
         projectFiles({"core", "backends", "effects", "configs", "tools", "tests", ".ci"})) {
        const bool listed = kKinds.count(path.extension().string()) != 0;
        if (!listed && path.filename() != "CMakeLists.txt") continue;
        INFO(path.string());
        const std::string head = firstLines(readText(fs::path(CREVICE_SOURCE_DIR) / path), 2);
        CHECK(head.find("SPDX-License-Identifier: MIT") != std::string::npos);
    }
}

TEST_CASE("test names have no character that CMake lists give a meaning")
{
    // catch_discover_tests keeps names in a list: a semicolon makes two tests of one, neither of
    // which runs anything or fails, and a lone bracket swallows all names that follow.
    for (const fs::path& path : projectFiles({"tests"})) {
        if (path.extension() != ".cpp") continue;
        const std::string code = codeOf(readText(fs::path(CREVICE_SOURCE_DIR) / path), true);
        for (const std::string& name :
             matches(code, R"re((?:^|\n)(?:TEST_CASE|SCENARIO)\("((?:\\.|[^"\\])*)")re", 1)) {
            INFO(path.string() << ": " << name);
            CHECK(name.find_first_of(";[]\\") == std::string::npos);
        }
    }
}
