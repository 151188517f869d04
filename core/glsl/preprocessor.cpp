// SPDX-License-Identifier: MIT
// Directives of GLSL: conditions, defines and includes.
#include "core/glsl/preprocessor.h"

#include "core/base/text.h"

namespace crevice {
namespace {

/// Files that include files that include files ...: keeps the recursion off the stack's end.
constexpr std::size_t kMaxIncludeDepth = 64;

constexpr std::size_t kShownBytes = 40;  ///< So much of a line is quoted in a message.

constexpr const char* kVersionHelp =
    "write '#version 300 es' above all but comments; all stages of a shader have one version";
constexpr const char* kConditionHelp =
    "a condition has whole numbers, defined(NAME), macros without arguments, parentheses and "
    "! && || == != < <= > >= + - * / %";
constexpr const char* kIncludeHelp =
    "write #include \"folder/file.glsl\" for a file or #include <name> for an interface";

/// One #if with its #elif and #else.
struct Branch {
    GlslToken opened;
    bool outer = true;    ///< What surrounds the #if is active.
    bool active = false;  ///< The part that is being read is.
    bool taken = false;   ///< Some part was.
    bool in_else = false;
};

struct Preprocessor {
    const std::map<std::string, SourceRef>& files;
    const std::map<std::string, std::string>& interfaces;
    GlslUnit& unit;
    std::vector<Branch> branches = {};
    std::vector<std::string> paths = {};  ///< By source-string number.
    std::vector<int> opened = {};         ///< The files being read, from the root on.
    std::set<std::string> seen = {};      ///< All files that were read.
    std::set<std::string, std::less<>> undefined = {};
    bool stopped = false;  ///< Nothing more can be said about this text.

    void readFile(const std::string& path)
    {
        const SourceRef& source = files.at(path);
        const std::size_t outer_branches = branches.size();
        opened.push_back(int(paths.size()));
        paths.push_back(path);
        seen.insert(path);
        unit.files.push_back(source);
        if (file() > 0) writeLine(1);

        BlankedText blanked = blankComments(source->text);
        if (blanked.open_line > 0)
            fail(Code::preprocessor, "a comment begins here and does not end",
                 {source, blanked.open_line, 1, 1}, "add '*/'");
        unit.blanked.push_back(std::move(blanked.text));
        for (const GlslLine& line : glslLines(unit.blanked.back(), file()))
            if (!stopped) readLine(line);

        for (; branches.size() > outer_branches; branches.pop_back())
            if (!stopped)
                fail("this #" + std::string(branches.back().opened.text) + " has no #endif",
                     branches.back().opened, "add '#endif' where what depends on it ends");
        opened.pop_back();
    }

    void mention(const GlslToken& token)
    {
        if (token.kind == GlslToken::Kind::identifier) unit.mentioned.insert(token.text);
    }

    bool active() const { return branches.empty() || branches.back().active; }
    int file() const { return opened.back(); }

    void fail(Code code, std::string message, const Place& place, std::string help)
    {
        unit.errors.push_back({code, std::move(message), std::move(help), place});
        stopped = stopped || unit.errors.size() == kMaxDiagnostics;
    }

    void fail(std::string message, const GlslToken& token, std::string help = {})
    {
        fail(Code::preprocessor, std::move(message), placeOf(token, unit.files), std::move(help));
    }

    void readLine(const GlslLine& line)
    {
        if (unit.version.empty()) return readFirstLine(line);
        if (line.isDirective()) return readDirective(line);
        unit.text += line.text;
        for (const GlslToken& token : line.tokens) {
            mention(token);
            if (active() && !stopped && !unit.macros.expand(token, unit.tokens)) spentSteps(token);
        }
    }

    /// Drops comments above #version, which must be the first line that the driver sees.
    void readFirstLine(const GlslLine& line)
    {
        if (line.tokens.empty()) return;
        const GlslTokens& tokens = line.tokens;
        const bool version = line.isDirective() && line.directive() == "version";
        const bool known = version && tokens.size() == 4 && tokens[3].is("es") &&
                           (tokens[2].is("300") || tokens[2].is("310"));
        if (!known) {
            const std::string_view shown = utf8Prefix(line.text, line.text.find('\n'));
            fail("the text begins with '" + std::string(utf8Prefix(shown, kShownBytes)) +
                     "', wanted '#version 300 es' or '#version 310 es'",
                 tokens[0], kVersionHelp);
            stopped = true;
            return;
        }
        unit.version = std::string(tokens[2].text) + " es";
        writeLine(line.line + line.count);
        unit.macros.define("__VERSION__", {tokens[2]});
    }

    void readDirective(const GlslLine& line)
    {
        if (line.directive() == "include") return readIncludeLine(line);
        unit.text += line.text;
        for (const GlslToken& token : line.tokens) mention(token);
        if (readBranch(line) || !active()) return;
        if (line.directive() == "define") readDefine(line);
        if (line.directive() == "extension") readExtension(line);
        if (line.directive() != "undef") return;
        if (const GlslToken* name = onlyName(line)) unit.macros.undefine(name->text);
    }

    void readExtension(const GlslLine& line)
    {
        if (!unit.tokens.empty())
            fail("this #extension stands below code", line.tokens[1], "move it up to #version");
        if (line.tokens.size() < 4 || !line.tokens.back().is("require")) return;
        fail("no device need have the extension '" + std::string(line.tokens[2].text) + "'",
             line.tokens[2], "write ': enable', and #ifdef around what uses it");
        unit.errors.back().severity = Severity::warning;
    }

    /// True when the line is one of the directives of an #if.
    bool readBranch(const GlslLine& line)
    {
        const std::string_view name = line.directive();
        if (name == "if" || name == "ifdef" || name == "ifndef") {
            openBranch(line);
            return true;
        }
        if (name != "elif" && name != "else" && name != "endif") return false;
        if (branches.empty() || branches.back().opened.file != file())
            fail("#" + std::string(name) + " without an #if in this file", line.tokens[1]);
        else if (name == "endif")
            branches.pop_back();
        else
            turnBranch(line);
        return true;
    }

    void openBranch(const GlslLine& line)
    {
        Branch branch;
        branch.opened = line.tokens[1];
        branch.outer = active();
        if (branch.outer && line.directive() == "if")
            branch.active = condition(line);
        else if (const GlslToken* name = branch.outer ? onlyName(line) : nullptr)
            branch.active = unit.macros.defined(name->text) == (line.directive() == "ifdef");
        branch.taken = branch.active;
        branches.push_back(branch);
    }

    void turnBranch(const GlslLine& line)
    {
        Branch& branch = branches.back();
        const bool last = line.directive() == "else";
        if (last && line.tokens.size() > 2)
            fail("#else takes no condition", line.tokens[2], "write #elif with the condition");
        if (branch.in_else)
            fail("#" + std::string(line.directive()) + " after #else", line.tokens[1],
                 "move it above the #else, or take it out");
        const bool open = branch.outer && !branch.taken && !branch.in_else;
        branch.active = open && (last || condition(line));
        branch.taken = branch.taken || branch.active;
        branch.in_else = branch.in_else || last;
    }

    bool condition(const GlslLine& line)
    {
        const GlslToken* end = line.tokens.data() + line.tokens.size();
        GlslTokens expanded;
        if (!unit.macros.expandCondition(line.tokens.data() + 2, end, expanded)) {
            spentSteps(line.tokens[1]);
            return false;
        }
        const auto value = evaluate(expanded.data(), expanded.data() + expanded.size());
        if (!value) blameCondition(line, expanded);
        return value.value_or(0) != 0;
    }

    /// Says what is wrong with a condition: a name without a #define, which C takes for 0 and GLSL
    /// ES refuses, is reported once for the whole stage.
    void blameCondition(const GlslLine& line, const GlslTokens& condition)
    {
        for (const GlslToken& token : condition) {
            if (token.kind != GlslToken::Kind::identifier || unit.macros.defined(token.text))
                continue;
            std::string help = suggestName(token.text, unit.macros.names(), "defined");
            if (!has(help, "did you mean"))
                help = "declare feature '" + lowerCase(token.text) +
                       "', or such a param with bind 'define'";
            if (undefined.emplace(token.text).second)
                fail("a condition has '" + std::string(token.text) + "', which is not defined",
                     token, help.substr(0, help.find(" defined:")));
            return;
        }
        fail("the condition of #" + std::string(line.directive()) + " cannot be read",
             line.tokens[line.tokens.size() > 2 ? 2 : 1], kConditionHelp);
    }

    /// The name after #ifdef, #ifndef or #undef; null, with an error, where there is not just one.
    const GlslToken* onlyName(const GlslLine& line)
    {
        if (line.tokens.size() == 3 && line.tokens[2].kind == GlslToken::Kind::identifier)
            return &line.tokens[2];
        fail("#" + std::string(line.directive()) + " wants one name", line.tokens[1]);
        return nullptr;
    }

    void readDefine(const GlslLine& line)
    {
        const GlslTokens& tokens = line.tokens;
        if (tokens.size() < 3 || tokens[2].kind != GlslToken::Kind::identifier)
            return fail("#define wants a name", tokens[1]);
        const GlslToken& name = tokens[2];
        const bool arguments = tokens.size() > 3 && tokens[3].is("(") &&
                               tokens[3].line == name.line &&
                               tokens[3].column == name.column + int(name.text.size());
        const bool ends = tokens.size() == 5 && tokens[4].is(";");
        if (ends || (tokens.size() > 3 && tokens[3].is("=")))
            fail("#define takes all that follows the name, '=' and ';' too", name,
                 "write the value alone: #define TAPS 4");
        unit.macros.define(name.text, {tokens.begin() + 3, tokens.end()}, arguments);
    }

    /// The line itself never reaches the driver: blank lines, or the file, stand in for it.
    void readIncludeLine(const GlslLine& line)
    {
        GlslInclude include;
        std::string path;
        const bool wanted = active();
        const bool read = readInclude(line, unit.files[std::size_t(file())], include);
        if (wanted && !read) fail("this #include cannot be read", line.tokens[1], kIncludeHelp);
        if (!wanted || !read || !resolve(include, path) || inRing(include, path) ||
            seen.count(path)) {
            unit.text.append(std::size_t(line.count), '\n');
            return;
        }
        if (!endsWith(path, ".glsl") && has(files.at(path)->text, "#version"))
            fail(Code::preprocessor, "found an #include of a shader, which has a main of its own",
                 include.place, "move what both need into a .glsl file, and include that in both");
        if (opened.size() == kMaxIncludeDepth) {
            stopped = true;
            return fail(Code::include_cycle,
                        "found #include more than " + std::to_string(kMaxIncludeDepth) + " deep",
                        include.place, "let the shader include what it needs itself");
        }
        readFile(path);
        writeLine(line.line + line.count);
    }

    /// Says that what follows is that line of the file being read.
    void writeLine(int line)
    {
        unit.text += "#line " + std::to_string(file() * kLinesPerFile + line) + " " +
                     std::to_string(file()) + "\n";
    }

    /// Finds the path of an include among the files. False, with an error, when there is none.
    bool resolve(const GlslInclude& include, std::string& path)
    {
        const auto interface = interfaces.find(include.name);
        if (!include.interface)
            path = resolvePath(paths[std::size_t(file())], include.name);
        else if (interface != interfaces.end())
            path = interface->second;
        if (files.count(path)) return true;
        fail(Code::include_missing, "#include names '" + include.name + "', which does not exist",
             include.place, kIncludeHelp);
        return false;
    }

    /// True, with an error, when the file is being read already.
    bool inRing(const GlslInclude& include, const std::string& path)
    {
        const auto first = std::find_if(opened.begin(), opened.end(), [&](int number) {
            return paths[std::size_t(number)] == path;
        });
        if (first == opened.end()) return false;
        std::string chain;
        for (auto at = first; at != opened.end(); ++at) chain += paths[std::size_t(*at)] + " -> ";
        fail(Code::include_cycle, "an #include leads back to itself: " + chain + path,
             include.place, "move what both need into a third file");
        return true;
    }

    void spentSteps(const GlslToken& token)
    {
        stopped = true;
        fail("macros expand without end", token,
             "shorten the chain of #defines that this one begins");
    }
};

}  // namespace

void preprocess(const std::map<std::string, SourceRef>& files,
                const std::map<std::string, std::string>& interfaces, const std::string& path,
                GlslUnit& unit)
{
    for (const char* name : {"GL_ES", "GL_FRAGMENT_PRECISION_HIGH"}) {
        GlslTokens one;
        tokenize("1", -1, 0, one);
        unit.macros.define(name, std::move(one));
    }
    if (files.count(path) == 0) {
        unit.errors.push_back({Code::file_missing, "there is no shader file '" + path + "'"});
        return;
    }
    Preprocessor{files, interfaces, unit}.readFile(path);
    if (unit.version.empty() && unit.errors.empty())
        unit.errors.push_back({Code::preprocessor, "the text is empty, wanted a shader",
                               kVersionHelp, Place{unit.files[0], 1, 1, 1}});
}

Place placeOf(const GlslToken& token, const std::vector<SourceRef>& files)
{
    if (token.file < 0) return {};
    return {files[std::size_t(token.file)], token.line, token.column, int(token.text.size())};
}

bool readInclude(const GlslLine& line, const SourceRef& source, GlslInclude& include)
{
    const GlslTokens& tokens = line.tokens;
    include.interface = tokens.size() == 5 && tokens[2].is("<") && tokens[4].is(">");
    const bool quoted = tokens.size() == 3 && tokens[2].kind == GlslToken::Kind::quoted &&
                        tokens[2].text.size() > 2 && tokens[2].text.back() == '"';
    if (!include.interface && !quoted) return false;
    GlslToken name = tokens[include.interface ? 3 : 2];
    if (quoted) {
        name.text = name.text.substr(1, name.text.size() - 2);
        ++name.column;
    }
    include.name = name.text;
    include.place = {source, name.line, name.column, int(name.text.size())};
    return true;
}

}  // namespace crevice
