// SPDX-License-Identifier: MIT
// Motion as a table to read.
#include "tools/measure/motion/table.h"

#include "tests/support/catch.h"

#include <algorithm>

using namespace crevice;

TEST_CASE("a table of motion has a row a config, and a cell for each column")
{
    MotionFigures motion;
    motion.paths["pan"] = {0.0123, 0.05, 0.25, 0.004, 0.0678, 1000};
    motion.settled_after = 3;
    motion.uncovered = {{1, 0.3}, {2, 0.25}, {16, 0.1}};
    motion.uncovered_rest = 0.0912;
    MotionFigures restless = motion;
    restless.settled_after = 0;
    const std::string table = motionTable({{"a", 0.0456, motion}, {"b", 0.5, restless}});
    CHECK(table.find("| `a` | 0.0456 |  |  | 0.0123, 0.050, 0.250 |  |  | 0.0678 | 3 | 0.3000 |  | "
                     "0.1000 | 0.0912 |\n") != std::string::npos);
    CHECK(table.find("| `b` | 0.5000 |") != std::string::npos);
    CHECK(table.find("| never |") != std::string::npos);
    REQUIRE(std::count(table.begin(), table.end(), '\n') == 4);
    std::size_t begin = 0;
    for (int line = 0; line < 4; ++line) {
        const std::size_t end = table.find('\n', begin);
        CHECK(std::count(table.begin() + static_cast<std::ptrdiff_t>(begin),
                         table.begin() + static_cast<std::ptrdiff_t>(end), '|') == 14);
        begin = end + 1;
    }
}
