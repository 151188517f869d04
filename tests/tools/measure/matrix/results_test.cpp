// SPDX-License-Identifier: MIT
// The files that say what came of a matrix, read by what else reads such files.
#include "tools/measure/matrix/run.h"

#include "core/base/text.h"
#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/show/report/bench_report.h"

#include <nlohmann/json.hpp>

using namespace crevice;

namespace {

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
