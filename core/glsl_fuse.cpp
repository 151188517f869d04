// SPDX-License-Identifier: MIT
// Fusion of fragment shaders.
#include "core/glsl_fuse.h"

#include "core/glsl_code.h"
#include "core/glsl_scan.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace crevice {

namespace {

using Kind = GlslStatement::Kind;

// Calls of functions that begin no deeper than this are followed: GLSL knows no recursion, mistakes do.
constexpr int kDeepest = 16;

// ---- what a writer may be

bool isFetch(std::string_view function)
{
    return function.substr(0, 5) == "texel" ||
           (function.substr(0, 7) == "texture" && function != "textureSize");
}

// Texels that the function fetches, more than `most` or not. Functions of one name count as one.
int fetchesOf(const GlslCode& code, std::string_view function, int most, int depth = 0)
{
    int fetches = depth > kDeepest ? most + 1 : 0;
    for (const GlslStatement& each : code.statements()) {
        if (each.kind != Kind::function || !code[each.names[0]].is(function)) continue;
        for (std::size_t i = each.names[0] + 1; i + 1 < each.end && fetches <= most; ++i) {
            if (code[i].kind != GlslToken::Kind::identifier || !code[i + 1].is("(")) continue;
            fetches += isFetch(code[i].text) ? 1 : fetchesOf(code, code[i].text, most - fetches, depth + 1);
        }
    }
    return fetches;
}

int samplersOf(const GlslCode& code)
{
    int samplers = 0;
    for (const GlslStatement& each : code.statements())
        if (each.storage == "uniform" && code[each.type].text.find("sampler") != std::string_view::npos)
            samplers += static_cast<int>(each.names.size());
    return samplers;
}

// Whether it finds a pixel from the texels there of what it reads, with nothing that outlasts one call of it.
bool isPointwise(const GlslCode& code)
{
    static const std::set<std::string_view> kNever = {"for",  "while", "do",     "discard",
                                                      "dFdx", "dFdy",  "fwidth", "gl_FragDepth"};
    const auto is_never = [](const GlslToken& token) { return kNever.count(token.text) > 0; };
    const auto lasts = [](const GlslStatement& each) {
        return each.kind == Kind::variables && each.storage.empty();
    };
    const int samplers = samplersOf(code);
    return std::none_of(code.tokens().begin(), code.tokens().end(), is_never) &&
           std::none_of(code.statements().begin(), code.statements().end(), lasts) &&
           fetchesOf(code, "main", samplers) <= samplers;
}

// Its one output, a float or a vector of at least so many; null where it has another.
const GlslStatement* outputOf(const GlslCode& code, int channels)
{
    static constexpr std::string_view kTypes[] = {"float", "vec2", "vec3", "vec4"};
    const GlslStatement* output = nullptr;
    for (const GlslStatement& each : code.statements()) {
        if (each.storage != "out") continue;
        const auto* type = std::find(std::begin(kTypes), std::end(kTypes), code[each.type].text);
        const bool wide = type != std::end(kTypes) && type - std::begin(kTypes) + 1 >= channels;
        if (output || !wide || each.names.size() != 1 || each.end != each.names[0] + 2) return nullptr;
        output = &each;
    }
    return output;
}

// The tokens of a struct that name its members.
std::set<std::size_t> membersOf(const GlslCode& code, const GlslStatement& structure)
{
    std::set<std::size_t> members;
    bool typed = false;
    int depth = 0;
    for (std::size_t i = structure.names[0] + 2; i < structure.end; ++i) {
        const GlslToken& token = code[i];
        if (token.is("[")) ++depth;
        if (token.is("]")) --depth;
        if (token.is(";")) typed = false;
        if (depth > 0 || token.kind != GlslToken::Kind::identifier || isQualifier(token.text)) continue;
        if (typed) members.insert(i);
        typed = true;
    }
    return members;
}

// ---- the seam

// Tokens from `begin` to before `end`.
struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0;
};

// Where the reader samples at its own pixel; nothing where it does so elsewhere, or again.
std::optional<Stretch> callOf(const GlslCode& reader, const GlslSeam& seam)
{
    std::vector<std::size_t> uses;
    for (std::size_t i = 0; i < reader.tokens().size(); ++i)
        if (reader[i].is(seam.sampler) && reader.isFree(i)) uses.push_back(i);
    const GlslStatement* declaration = reader.declarationOf(seam.sampler);
    const bool once = declaration && declaration->names.size() == 1 && uses.size() == 2 &&
                      uses[0] == declaration->names[0];
    if (!once || declaration->precision != "highp") return std::nullopt;
    const std::size_t begin = uses[1] - 2;
    if (reader.stands(begin, {"texelFetch", "(", seam.sampler, ",", "ivec2", "(", "gl_FragCoord", ".", "xy",
                              ")", ",", "0", ")"})) return Stretch{begin, begin + 13};
    const bool spans = !seam.uv.empty() && !reader.isHidden(begin, seam.uv);
    if (spans && reader.stands(begin, {"texture", "(", seam.sampler, ",", seam.uv, ")"}))
        return Stretch{begin, begin + 6};
    return std::nullopt;
}

// The declaration with its precision, as text: alike where the text is.
std::string declared(const GlslCode& code, const GlslStatement& statement)
{
    std::string text = std::string(statement.storage) + " " + std::string(statement.precision);
    for (std::size_t i = statement.type; i < statement.end; ++i) text += " " + std::string(code[i].text);
    return text;
}

// ---- one text

// Writes tokens at the author's lines.
class Printer {
public:
    explicit Printer(const std::string& version) : text_("#version " + version) {}

    void print(const GlslToken& token, int first_file, std::string_view as)
    {
        const int file = token.file + first_file;
        if (file != file_ || token.line < line_ || token.line > line_ + 3)
            text_ += "\n#line " + std::to_string(file * kLinesPerFile + token.line) + " " +
                     std::to_string(file) + "\n";
        else if (token.line > line_)
            text_.append(static_cast<std::size_t>(token.line - line_), '\n');
        else if (token.text.data() != behind_)  // signs that stood together may be one
            text_ += ' ';
        file_ = file;
        line_ = token.line;
        behind_ = token.text.data() + token.text.size();
        text_ += as;
    }

    void printLine(const std::string& line)
    {
        text_ += "\n" + line;
        file_ = -1;
    }

    std::string text() const { return text_ + "\n"; }

private:
    std::string text_;
    int file_ = -1;
    int line_ = 0;
    const char* behind_ = nullptr;
};

class Fusion {
public:
    /// Requires a writer that is known.
    Fusion(const GlslCode& writer, const GlslCode& reader, const GlslSeam& seam, int writer_files)
        : seam_(seam),
          writer_files_(writer_files),
          writer_(writer),
          reader_(reader),
          prefix_("fused_" + seam.writer + "_")
    {
    }

    /// False where they stay two.
    bool prepare();

    /// Requires prepare().
    std::string text() const;

private:
    bool settleNames();
    bool settle(const GlslStatement& declaration, std::string_view name);
    void drop(const GlslStatement& of_reader) { dropped_[of_reader.begin] = of_reader.end; }
    void printWriter(Printer& printer) const;
    void printSeam(Printer& printer) const;
    void printReader(Printer& printer) const;

    const GlslSeam& seam_;
    int writer_files_;
    const GlslCode& writer_;
    const GlslCode& reader_;
    std::string prefix_;
    const GlslStatement* output_ = nullptr;
    Stretch call_;
    std::set<std::string_view> renamed_;          ///< Of the writer.
    std::set<std::size_t> members_;               ///< Of the writer's structs.
    std::map<std::size_t, std::size_t> dropped_;  ///< Of the reader: where a statement begins and ends.
};

bool Fusion::prepare()
{
    if (!reader_.known() || writer_.version() != reader_.version()) return false;
    output_ = outputOf(writer_, seam_.channels);
    const std::optional<Stretch> call = callOf(reader_, seam_);
    if (!output_ || !call) return false;
    call_ = *call;
    drop(*reader_.declarationOf(seam_.sampler));
    return settleNames();
}

// Inputs and uniforms keep their names; all else that the writer declares gets the prefix.
bool Fusion::settleNames()
{
    const auto has_prefix = [&](const GlslToken& token) {
        return token.text.substr(0, prefix_.size()) == prefix_;
    };
    if (prefix_.find("__") != prefix_.npos) return false;  // reserved
    if (std::any_of(reader_.tokens().begin(), reader_.tokens().end(), has_prefix)) return false;
    for (const GlslStatement& each : writer_.statements()) {
        if (each.kind == Kind::structure) members_.merge(membersOf(writer_, each));
        for (const std::size_t index : each.names)
            if (!settle(each, writer_[index].text)) return false;
    }
    return true;
}

bool Fusion::settle(const GlslStatement& declaration, std::string_view name)
{
    if (declaration.storage != "in" && declaration.storage != "uniform") {
        renamed_.insert(name);
        return true;
    }
    const GlslStatement* other = reader_.declarationOf(name);
    if (!other) return true;
    drop(*other);
    return declaration.names.size() == 1 && other->names.size() == 1 && name != seam_.sampler &&
           declared(writer_, declaration) == declared(reader_, *other);
}

void Fusion::printWriter(Printer& printer) const
{
    for (std::size_t i = 0; i < writer_.tokens().size(); ++i) {
        const GlslToken& token = writer_[i];
        const bool qualifies = i >= output_->begin && i < output_->type && token.text != output_->precision;
        if (qualifies) continue;  // the output is a variable now
        const bool renamed = renamed_.count(token.text) > 0 && writer_.isFree(i) && members_.count(i) == 0;
        printer.print(token, 0, renamed ? prefix_ + std::string(token.text) : std::string(token.text));
    }
}

// A function that gives what sampling the texture would.
void Fusion::printSeam(Printer& printer) const
{
    static constexpr const char* kParts[] = {".x", ".y", ".z", ".w"};
    const std::string output = prefix_ + std::string(writer_[output_->names[0]].text);
    const bool scalar = writer_[output_->type].is("float");
    std::string value;
    for (int i = 0; i < 4; ++i) {
        const std::string held = output + (scalar ? "" : kParts[i]);
        value += (i > 0 ? ", " : "") + (i < seam_.channels ? held : std::string(i < 3 ? "0.0" : "1.0"));
    }
    printer.printLine("highp vec4 " + prefix_ + "stored()");
    printer.printLine("{ " + prefix_ + "main(); highp vec4 v = vec4(" + value + "); return " + seam_.stored +
                      "; }");
}

void Fusion::printReader(Printer& printer) const
{
    for (std::size_t i = 0; i < reader_.tokens().size(); ++i) {
        const GlslToken& token = reader_[i];
        if (const auto statement = dropped_.find(i); statement != dropped_.end()) {
            i = statement->second - 1;
        } else if (i == call_.begin) {
            printer.print(token, writer_files_, prefix_ + "stored()");
            i = call_.end - 1;
        } else {
            printer.print(token, writer_files_, token.text);
        }
    }
}

std::string Fusion::text() const
{
    Printer printer(writer_.version());
    printWriter(printer);
    printSeam(printer);
    printReader(printer);
    return printer.text();
}

}  // namespace

std::optional<GlslStage> fuse(const GlslStage& writer, const GlslStage& reader, const GlslSeam& seam)
{
    const GlslCode from(writer);
    if (!from.known() || !isPointwise(from)) return std::nullopt;  // as most, and readers take longer
    const GlslCode to(reader);
    Fusion fusion(from, to, seam, static_cast<int>(writer.files.size()));
    if (!fusion.prepare()) return std::nullopt;
    GlslStage fused;
    fused.text = fusion.text();
    fused.files = writer.files;
    fused.files.insert(fused.files.end(), reader.files.begin(), reader.files.end());
    fused.uniforms = writer.uniforms;
    for (const GlslUniform& each : reader.uniforms)
        if (each.name != seam.sampler && !declares(writer, each.name)) fused.uniforms.push_back(each);
    fused.outputs = reader.outputs;
    std::set_union(writer.defines_used.begin(), writer.defines_used.end(), reader.defines_used.begin(),
                   reader.defines_used.end(), std::back_inserter(fused.defines_used));
    return fused;
}

std::string spanningOutput(const GlslStage& vertex)
{
    const GlslCode code(vertex);
    if (!code.known() || code.statements().empty()) return {};
    const GlslStatement& main = code.statements().back();
    constexpr std::size_t kWords = 16;  // gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0); }
    if (main.kind != Kind::function || !code[main.names[0]].is("main") || main.end - main.begin <= kWords) return {};
    const std::size_t at = main.end - kWords;
    const std::string_view name = code[at + 4].text;
    const bool spans = code.stands(at, {"gl_Position", "=", "vec4", "(", name, "*", "2.0", "-", "1.0", ",", "0.0",
                                        ",", "1.0", ")", ";", "}"});
    const bool always = code[at - 1].is(";") || code[at - 1].is("{");
    const GlslStatement* output = code.declarationOf(name);
    const bool known = output && output->storage == "out" && !code.isHidden(at, name);
    return spans && always && known ? std::string(name) : std::string();
}

}  // namespace crevice
