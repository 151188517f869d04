// SPDX-License-Identifier: MIT
#include "tools/measure/cost/loops.h"
#include "core/base/text.h"
#include "tests/support/catch.h"

using namespace crevice;

namespace {

std::string shader(const std::string& before, const std::string& body)
{
    return "#version 300 es\n" + before + "\nvoid main()\n{\n" + body + "\n}\n";
}

std::string cut(const std::string& text, TextPart part)
{
    return text.substr(part.begin, part.end - part.begin);
}

/// The loops as they stand in the text.
std::vector<std::string> found(const std::string& text)
{
    std::vector<std::string> wholes;
    for (const GlslLoop& loop : loopsOf(text)) wholes.push_back(cut(text, loop.whole));
    return wholes;
}

/// The body of main without loops, in one line.
std::string written(const std::string& body, int twice)
{
    const std::string text = shader("", body);
    const std::string all = withoutLoops(text, loopsOf(text), twice);
    const std::string body_of_main = all.substr(all.find('{') + 1);
    std::string words;
    for (const std::string_view word : split(body_of_main, '\n'))
        if (!word.empty()) words.append(trimmed(word)).append(" ");
    return words.substr(0, words.rfind(" }"));
}

GlslLoop around(std::vector<int> loops) { return {{}, {}, {}, {}, {}, std::move(loops)}; }

}  // namespace

TEST_CASE("A loop is a for or a while with the statement that it runs, in braces or not")
{
    const std::string text = shader("", "for (int i = 0; i < 4; ++i) { a(); }");
    const GlslLoop loop = loopsOf(text).at(0);
    CHECK(cut(text, loop.whole) == "for (int i = 0; i < 4; ++i) { a(); }");
    CHECK(cut(text, loop.initial) == "int i = 0");
    CHECK(trimmed(cut(text, loop.condition)) == "i < 4");
    CHECK(trimmed(cut(text, loop.step)) == "++i");
    CHECK(cut(text, loop.body) == "{ a(); }");
    for (const char* each :
         {"while (f(i)) { a(); }", "for (;;) break;", "while (i < 4) if (a) b(); else { c(); }",
          "for (; i < 4;) if (a) { b(); }"}) {
        INFO(each);
        CHECK(found(shader("", std::string(each) + " d();")) == std::vector<std::string>{each});
    }
}

TEST_CASE("A do, what is not active and what a macro writes are no loops")
{
    for (const char* body :
         {"do { a(); } while (i < 4);", "// for (;;) {}", "\n#if 0\nfor (;;) {}\n#endif\n"}) {
        INFO(body);
        CHECK(found(shader("", body)).empty());
    }
    const char* const macros = "#define LOOP for (int i = 0; i < 4; ++i)\n#define EACH(i) for (;;)";
    CHECK(found(shader(macros, "LOOP { a(); }\nEACH(i) { b(); }")).empty());
    CHECK(found(shader("", "{\n#define LOOP for (;;)\nLOOP { a(); }\n}")).empty());
    CHECK(found(shader("#define N 4", "for (int i = N; i < N; i += N) {}")).size() == 1);
    CHECK(found("for (;;) {}").empty());  // no #version: it cannot be read
}

TEST_CASE("A loop is around those that its body holds or calls, however deep")
{
    const std::string text =
        shader("void inner() { while (a) {} }\nvoid middle() { inner(); }\nvoid other() {}",
               "for (;;) { for (;;) other(); }\nfor (;;) { middle(); }\nother();");
    const std::vector<GlslLoop> loops = loopsOf(text);
    REQUIRE(loops.size() == 4);
    CHECK(loops[0].around == std::vector<int>{3});
    CHECK(loops[1].around.empty());
    CHECK(loops[2].around == std::vector<int>{1});
    CHECK(loops[3].around.empty());
}

TEST_CASE("Without loops each body is there once, and one of them twice")
{
    CHECK(written("for (int i = 0; i < 4; ++i) { a(); }", -1) ==
          "{ int i = 0; if ( i < 4) { a(); } ++i; }");
    CHECK(written("while (b) a();", 0) == "{ ; if (b) a(); ; if (b) a(); ; }");
    CHECK(written("#if 1\nwhile (b)\n#endif\n{ a(); }", -1) ==
          "#if 1 { ; #endif if (b) { a(); } ; }");
    CHECK(written("for (;;) { a(); break; }", -1) ==
          "{ ; do { if (!(true)) break; { a(); break; } } while (false); ; }");
    CHECK(written("while (b) while (c) a();", 1) ==
          "{ ; if (b) { ; if (c) a(); ; if (c) a(); ; } ; }");
}

TEST_CASE("What a shader costs is what each body costs, as often as it and the loops around it run")
{
    // 7 + 4 * (10 + 3 * 5) + 2 * 20
    const std::vector<GlslLoop> loops = {around({}), around({0}), around({})};
    const double once = 7 + 10 + 5 + 20;
    const std::vector<double> twice = {once + 10 + 5, once + 5, once + 20};
    CHECK(costAsItRuns(loops, once, twice, {4, 3, 2}) == 7 + 4 * (10 + 3 * 5) + 2 * 20);
    CHECK(costAsItRuns(loops, once, twice, {1, 1, 1}) == once);
    CHECK(costAsItRuns(loops, once, twice, {0, 3, 0}) == 7);
    // 4 * (10 + 3 * (5 + 2 * 6)): the outermost is around both others
    const std::vector<GlslLoop> deep = {around({}), around({0}), around({0, 1})};
    CHECK(costAsItRuns(deep, 21, {42, 32, 27}, {4, 3, 2}) == 4 * (10 + 3 * (5 + 2 * 6)));
    CHECK(costAsItRuns({around({})}, 30, {25}, {9}) == 30);  // a body twice takes no less
}
