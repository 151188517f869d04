// SPDX-License-Identifier: MIT
// Matrix files: what is read, what is refused and where, and which cells come of it.
// The files that say what came of a matrix, read by what else reads such files.
#include "tools/measure/matrix/keys.h"
#include "tools/measure/matrix/plan.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/measure/matrix/run.h"
#include "tools/render/image/image_file.h"
#include "tools/show/report/bench_report.h"

#include <crevice/shipped.h>

#include <nlohmann/json.hpp>

using namespace crevice;

namespace {

/// A matrix file of a folder of its own.
Result<Matrix> read(const std::string& text)
{
    static const TemporaryFolder folder("matrix");
    return readMatrix(folder.write("matrix.json", text), shippedSources());
}

/// One line, so that columns count from its beginning.
std::string withChecks(const std::string& keys, const std::string& checks = R"({"finite": true})")
{
    return R"({"format": 1, "configs": ["gtao", "mobile"], "scenes": ["corner", "plane"], )" +
           keys + R"("checks": [)" + checks + "]}";
}

std::vector<std::string> namesOf(const Matrix& matrix)
{
    std::vector<std::string> names;
    for (const MatrixCell& cell : matrix.cells) names.push_back(cell.name);
    return names;
}

/// A name that ends whatever it stands in, and a control character.
const std::string kHostile = "</script><a b=\"c\">&amp; # \\ 'x' \x1b[31m ]]> \n not ok";

struct Hostile {
    Matrix matrix;
    MatrixResults results{matrix};

    Hostile()
    {
        matrix.file = kHostile;
        matrix.axes = {{"config", {{kHostile, "gtao", {}}}}};
        matrix.cells = {{{0}, kHostile, "a", "a"}, {{0}, "plain", "b", "b"}};
        results.cells = {
            {0, "key", {{0, kHostile, "failed", kHostile, 0.5}, {1, "plain", "passed", "", 0.25}}},
            {1, "key", {{0, "plain", "skipped", kHostile}}}};
    }
};

}  // namespace

TEST_CASE("What is wrong in a matrix file is told with its place and a way out")
{
    const struct {
        std::string text;
        Code code;
        std::string at;  // what the place begins with
    } cases[] = {
        {R"({"configs": ["gtao"], "scenes": ["corner"], "checks": [{"finite": true}]})",
         Code::format_version, "{"},
        {withChecks(R"("format ": 1, )"), Code::unknown_key, "\"format \""},
        {withChecks(R"("camera": ["frame"], )"), Code::unknown_key, "\"camera\""},
        {withChecks(R"("cameras": "frame", )"), Code::wrong_type, "\"frame\""},
        {withChecks(R"("cameras": [1], )"), Code::wrong_type, "1]"},
        {withChecks(R"("cameras": [], )"), Code::bad_length, "[]"},
        {withChecks(R"("sizes": ["64x"], )"), Code::bad_size, "\"64x\""},
        {withChecks(R"("sizes": ["64x36", "64x36"], )"), Code::duplicate_key, "\"64x36\"]"},
        {withChecks(R"("backends": ["elg"], )"), Code::bad_enum, "\"elg\""},
        {withChecks(R"("params": {"radius": 1}, )"), Code::wrong_type, "1}"},
        {withChecks(R"("params": {"scene": [1]}, )"), Code::name_collision, "\"scene\""},
        {withChecks(R"("combine": "pairs", )"), Code::bad_enum, "\"pairs\""},
        {withChecks(R"("cells": [{"confg": "gtao"}], )"), Code::reference_missing, "\"confg\""},
        {withChecks(R"("cells": [{"config": "gtoa"}], )"), Code::reference_missing, "\"gtoa\""},
        {withChecks(R"("approved_format": "jpg", )"), Code::bad_enum, "\"jpg\""},
        {withChecks("", ""), Code::bad_length, "[]"},
        {withChecks("", R"({"where": {"config": "gtao"}})"), Code::missing_key, "{\"where\""},
        {withChecks("", R"({"finite": true, "plan": true})"), Code::name_collision, "{\"finite\""},
        {withChecks("", R"({"finite": false})"), Code::wrong_type, "false"},
        {withChecks("", R"({"approved": {}})"), Code::missing_key, "{}"},
        {withChecks("", R"({"approved": {"share": 0.1}})"), Code::missing_key, "{\"share\""},
        {withChecks("", R"({"approved": {"max": 2}})"), Code::out_of_range, "2}"},
        {withChecks("", R"({"truth": {"rsme": 0.1}})"), Code::unknown_key, "\"rsme\""},
        {withChecks("", R"({"truth": {"rmse": 0.1, "rays": 1.5}})"), Code::wrong_type, "1.5"},
        {withChecks("", R"({"same": {"max": 0}})"), Code::missing_key, "{\"max\""},
        {withChecks("", R"({"same": {"as": {"config": ["gtao", "mobile"]}}})"), Code::bad_length,
         "{\"config\""},
        {withChecks("", R"({"time": {"over": {"config": "gtao"}}})"), Code::missing_key,
         "{\"over\""},
        {withChecks("", R"({"range": [1, 0]})"), Code::bad_range, "[1, 0]"},
        {withChecks("", R"({"open": {"share": 0}})"), Code::missing_key, "{\"share\""},
        {withChecks("", R"({"same": {"as": {"scene": "plane"}}, "where": {"scene": "plane"}})"),
         Code::unused_name, "\"same\""},
        {withChecks("", R"({"finite": true, "where": {"scene": "plane"}})"), Code::unused_name,
         "\"gtao\""},
        {withChecks(R"("cameras": ["eye=1,1,1", "eye=1;1;1"], )"), Code::name_collision,
         "\"gtao\""},
    };
    for (const auto& [text, code, at] : cases) {
        INFO(text);
        const Result<Matrix> matrix = read(text);
        REQUIRE(!matrix.ok());
        const Diagnostic& error = matrix.diagnostics().front();
        INFO(toText(error));
        CHECK(error.code == code);
        REQUIRE(error.place.column > 0);
        CHECK(startsWith(text.substr(error.place.column - 1), at));
        CHECK(!error.help.empty());
    }
    CHECK(read(R"({"formt": 1, "config": [], "scenes": ["corne"]})").diagnostics().size() == 5);
    CHECK(has(readMatrix(".", shippedSources()).diagnostics()[0].message, "is a folder"));
}

TEST_CASE(
    "Configs, scenes and outputs are found before anything is drawn, or told with their place")
{
    const struct {
        std::string text;
        Code code;
        std::string at;
    } cases[] = {
        {withChecks(R"("variants": ["gone"], )"), Code::variant_missing, ""},
        {withChecks(R"("params": {"raduis": [1]}, )"), Code::unknown_param, ""},
        {withChecks("", R"({"finite": true, "output": "oa"})"), Code::output_missing, "\"finite\""},
        {withChecks(R"("cameras": ["left"], )"), Code::camera_missing, "\"left\""},
    };
    for (const auto& [text, code, at] : cases) {
        INFO(text);
        const Matrix matrix = need(read(text));
        const Result<MatrixPlan> plan = planMatrix(matrix, {}, shippedSources());
        REQUIRE(!plan.ok());
        const Diagnostic& error = plan.diagnostics().front();
        INFO(toText(error));
        CHECK(error.code == code);
        if (at.empty())
            CHECK(error.notes.size() > 0);  // the place in the matrix file
        else
            CHECK(startsWith(text.substr(error.place.column - 1), at));
    }
}

TEST_CASE("Cells are all combinations, or those that are listed")
{
    const std::string axes = R"("params": {"radius": [0.5, 1]}, )";
    CHECK(namesOf(need(read(withChecks(axes)))) ==
          std::vector<std::string>{"gtao, corner, radius=0.5", "gtao, corner, radius=1",
                                   "mobile, corner, radius=0.5", "mobile, corner, radius=1",
                                   "gtao, plane, radius=0.5", "gtao, plane, radius=1",
                                   "mobile, plane, radius=0.5", "mobile, plane, radius=1"});
    CHECK(namesOf(need(read(withChecks(R"("cells": [{"config": "gtao", "scene": "plane"}], )")))) ==
          std::vector<std::string>{"gtao, plane"});
    CHECK(
        need(
            read(
                R"({"format": 1, "configs": "all", "scenes": ["plane"], "checks": [{"finite": true}]})"))
            .cells.size() == configNames(shippedSources()).size());
}

TEST_CASE("A pairwise matrix has every pair of values in few cells")
{
    const Matrix matrix = need(read(withChecks(
        R"("combine": "pairwise", "sizes": ["8x8", "9x9", "10x10"],
           "params": {"radius": [1, 2, 3], "power": [1, 2, 3]}, "backends": ["egl", "osmesa"], )")));
    std::set<std::vector<std::size_t>> pairs;
    for (const MatrixCell& cell : matrix.cells)
        for (std::size_t a = 0; a < cell.choice.size(); ++a)
            for (std::size_t b = a + 1; b < cell.choice.size(); ++b)
                pairs.insert({a, cell.choice[a], b, cell.choice[b]});
    std::size_t wanted = 0;
    for (std::size_t a = 0; a < matrix.axes.size(); ++a)
        for (std::size_t b = a + 1; b < matrix.axes.size(); ++b)
            wanted += matrix.axes[a].values.size() * matrix.axes[b].values.size();
    CHECK(pairs.size() == wanted);
    CHECK(matrix.cells.size() >= 9);
    CHECK(matrix.cells.size() <= 13);  // of 180
}

TEST_CASE("Shards are all cells, each once; a filter chooses by name")
{
    const std::vector<std::size_t> list = {1, 2, 3, 5, 8, 13, 21};
    std::vector<std::size_t> all;
    for (std::size_t shard = 1; shard <= 5; ++shard)
        for (const std::size_t each : shardOf(list, shard, 5)) all.push_back(each);
    CHECK(all == list);
    const Matrix matrix = need(read(withChecks(R"("params": {"radius": [1, 2, 3]}, )")));
    MatrixOptions options;
    options.filter = "gtao, plane";
    CHECK(need(planMatrix(matrix, options, shippedSources())).cells.size() == 3);
    options.filter = "gtoa";
    CHECK(has(planMatrix(matrix, options, shippedSources()).diagnostics()[0].help, "'gtao, c"));
}

TEST_CASE("A cell's key is another one when its config, view, checks or approved file change")
{
    const auto keyOfFirst = [](const std::string& keys, const std::string& check) {
        const Matrix matrix = need(read(withChecks(keys, check)));
        const MatrixPlan plan = need(planMatrix(matrix, {}, shippedSources()));
        return keyOf(plan, matrix.cells[0], "1");
    };
    const std::string check = R"({"approved": {"max": 0.1}})";
    std::set<std::string> keys;
    keys.insert(keyOfFirst("", check));
    keys.insert(keyOfFirst("", check));
    CHECK(keys.size() == 1);
    keys.insert(keyOfFirst("", R"({"approved": {"max": 0.2}})"));
    for (const char* changed : {R"("params": {"radius": [1]}, )", R"("sizes": ["64x36"], )",
                                R"("cameras": ["frame=top"], )", R"("backends": ["osmesa"], )"})
        keys.insert(keyOfFirst(changed, check));
    const Matrix matrix = need(read(withChecks("", check)));
    const std::string file = approvedFile(matrix, matrix.cells[0], matrix.checks[0]);
    std::filesystem::create_directories(matrix.approved_folder);
    need(writeFile(file, "approved"));
    keys.insert(keyOfFirst("", check));
    CHECK(keys.size() == 7);
    CHECK(endsWith(matrix.approved_folder, "/approved/matrix"));
}

TEST_CASE("The page on matrix files names every key that they may have")
{
    const std::string page =
        readBytes(CREVICE_SOURCE_DIR "/docs/reference/matrix.md", 1 << 20).bytes;
    for (const std::string& key : matrixKeys()) {
        INFO(key);
        CHECK((has(page, "`" + key + "`") || has(page, "`\"" + key + "\"")));
    }
}

TEST_CASE("JUnit XML is read by an XML parser, with its counts and names")
{
    const Hostile hostile;
    const TemporaryFolder folder("junit");
    folder.write("junit.xml", junitXml(hostile.results));
    const std::string script = folder.write("read.py", R"(import sys, xml.etree.ElementTree as tree
root = tree.parse(sys.argv[1]).getroot()
assert (root.tag, root.get('tests'), root.get('failures'), root.get('skipped'), root.get('time')) == (
    'testsuites', '3', '1', '1', '0.750'), root.attrib
assert [suite.get('tests') for suite in root] == ['2', '1']
cases = list(root.iter('testcase'))
assert [[child.tag for child in case] for case in cases] == [['failure'], [], ['skipped']]
said = cases[0].find('failure').get('message')
assert said.startswith('</script><a b="c">&amp; # \\ \'x\' \\u001b[31m ]]> \\u000a'), said
)");
    const std::string run = "python3 " + script + " " + (folder.path / "junit.xml").string();
    CHECK(std::system(run.c_str()) == 0);
}

TEST_CASE("TAP has its plan, a line for each point, and no directive that nobody wrote")
{
    const Hostile hostile;
    const std::string tap = tapText(hostile.results);
    std::vector<std::string_view> points;
    for (const std::string_view line : split(tap, '\n'))
        if (startsWith(line, "ok ") || startsWith(line, "not ok ")) points.push_back(line);
    CHECK(startsWith(tap, "TAP version 13\n1..3\n"));
    REQUIRE(points.size() == 3);
    CHECK(startsWith(points[0], "not ok 1 - </script>"));
    CHECK(startsWith(points[1], "ok 2 - "));
    CHECK(startsWith(points[2], "ok 3 - plain: plain # SKIP "));
    for (const std::string_view point : points)  // a bare '#' begins a directive
        for (std::size_t at = 1; at < point.size(); ++at)
            if (point[at] == '#' && point[at - 1] != '\\')
                CHECK(startsWith(point.substr(at), "# SKIP"));
    CHECK(has(tap, "  ---\n  message: \"</script>"));
}

TEST_CASE("Results are JSON without times, lines of them come back, and the page holds them")
{
    const Hostile hostile;
    const nlohmann::json json = resultsJson(hostile.results);
    CHECK(json["failed"] == 1);
    CHECK(json["skipped"] == 1);
    CHECK(json["cells"].size() == 2);
    CHECK(!has(json.dump(), "time"));
    const CellResult again = cellResultFrom(toJson(hostile.results.cells[0]));
    CHECK(toJson(again) == toJson(hostile.results.cells[0]));
    const std::string page = pageOf(matrixPage(), json);
    CHECK(occurrences(page, "</script>") == 2);  // those that the page has itself
    CHECK(!has(page, "\x1b"));
}
