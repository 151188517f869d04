// SPDX-License-Identifier: MIT
// The words are those of glslang and ANGLE, which have one origin, and of Mesa where it says much
// the same.
#include "core/glsl/compiler_words.h"

#include "core/base/text.h"

#include <tuple>

namespace crevice {

namespace {

constexpr std::string_view kBuiltIn =
    "void bool int uint float vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4 "
    "mat2 mat3 mat4 sampler2D sampler2DMS uniform const radians degrees sin cos tan asin acos atan "
    "sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt inversesqrt abs sign floor trunc "
    "round roundEven ceil fract mod modf min max clamp mix step smoothstep isnan isinf "
    "floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat packSnorm2x16 unpackSnorm2x16 "
    "packUnorm2x16 unpackUnorm2x16 packHalf2x16 unpackHalf2x16 length distance dot cross normalize "
    "faceforward reflect refract matrixCompMult outerProduct transpose determinant inverse "
    "lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual any all not textureSize "
    "texture textureLod textureOffset texelFetch texelFetchOffset textureGrad textureGather dFdx "
    "dFdy fwidth gl_Position gl_PointSize gl_VertexID gl_InstanceID gl_FragCoord gl_FrontFacing "
    "gl_PointCoord gl_FragDepth";

/// Names of other GLSL, of HLSL and of desktops, and what is not supported; and what to write.
constexpr std::string_view kElsewhere = R"(
then|{ } around what depends on it: if (x > 0.0) { ... }
auto,var,let|a type: float, vec2, vec3 ...
and|&&
or|||
null,NULL,None,True,False|a number, true or false
new,static_cast|float(...) or vec3(...) alone
using,namespace,template,class,typedef,import,goto|plain functions and structs
cout,printf,print|it into a target, which crevice render draws
PI,M_PI|3.14159265
Math,std|the function alone: max(a, b)
texture2D,tex2D|texture(...)
gl_FragColor,gl_FragData|an output of your own: layout(location = 0) out vec4 color;
varying|out in the vertex shader and in in the fragment shader
attribute|in
sampler2DMS|#version 310 es in both shaders, which has it
saturate|clamp(x, 0.0, 1.0)
lerp|mix(...)
frac|fract(...)
fma|a * b + c
atan2|atan(y, x)
float2,float3,float4|vec2, vec3 or vec4
half|mediump float
double,real,f32|float
elif,elseif,elsif|else if
textureGather|four texelFetch(...)
dFdxFine,dFdyFine,ddx,ddy|dFdx(...) or dFdy(...)
precise,noperspective,static,inline,extern,export,constexpr|the declaration without it
binding,early_fragment_tests|no such layout: the config binds samplers by name
std430,buffer|a sampler, or a uniform array: uniform vec3 kernel[16];
gl_ClipDistance|discard where the distance is below 0
gl_SampleID|a shader for whole pixels
scalar swizzle|x for x.x: a number has no components
variable indexing sampler array|a constant index
{ } style initializers|a call of the type: float[](1.0, 2.0)
arrays of arrays|one array of both sizes: w[i * 2 + j]
.length|the number of components
local function declaration|it outside of all functions
extraneous semicolon|no ';' behind a function's '}'
token pasting|the whole name
non-constant global initializer|the declaration alone, and compute it in main()
)";

/// What a compiler says, what it is called here, and the way out; $ is the name it is about.
constexpr std::string_view kMessages = R"(
eserved word|'$' is a word that GLSL ES keeps for itself|take another name
redefinition of built-in|'$' is a function of GLSL itself|take another name
redefinition|'$' is declared twice|rename one of them, or take it out
redeclaration|'$' is declared twice|rename one of them, or take it out
already has a body|function '$' has two bodies|rename one of them, or take it out
modify shader input|'$' is an input, which nothing may write|write to a copy of it
modify a uniform|'$' is a uniform, which nothing may write|write to a copy of it
modify a const|this is const or a plain value, which nothing may write|write to a variable
duplicate components|a component is written twice|name each once: .xy
value required|this is a plain value, which nothing may write, an 'out' either|give it a variable
wrong operand type no operation|this operator does not take that type|compare: x > 0.0
location|two outputs have one location|number them: layout(location = 1) out ...
overloaded functions must|functions of one name differ in their parameters alone|rename one of them
return type|this is not of the type that the function returns|return that type, or change it
sampler/image types|a sampler has to be a uniform or a parameter|read the uniform itself
non-constant initializer|a const has to have a constant value|leave out 'const'
array size must|the size of an array has to be constant|write a number or a #define
index out of range|there is no element $|indices go from 0 to the length - 1
array size required|the array has no size|write how many it holds: float w[3];
Types must match|'$' has another type in the other shader|declare it alike in both
qualifiers must match|'$' is qualified otherwise in the other shader|declare it alike, as 'highp'
default precision|'$' has no precision in this shader|write below #version: precision highp $;
void function cannot return|a void function returns no value|write: return;
literal too big|the number has more than 32 bits|write a smaller one
octal|a number that begins with 0 is octal|take the 0 off
literal|GLSL has no text in quotes|write a number
no such field|the struct has no member '$'|take one that its declaration has
boolean expression expected|a condition has to be true or false|compare: x > 0.0, x == 1.0
function does not return a value|function '$' can end without a return|end each way with a return
swizzle selection|the vector is too short for '.$'|take components that it has: .x or .xy
not enough data|there are too few values for this vector or matrix|give one, or one for each
one argument per|this array has another number of values|give one for each of its elements
entry point|the shader has no function main that returns void|add: void main() { ... }
swizzle too long|a vector has no '$'|take its components: .x or .xy
does not apply to this type|this has no '$'|take components of vectors and members of structs alone
use function syntax|'$' is a variable here, which hides the function|rename the variable
last qualifier|the precision stands right before the type|write as in: uniform mediump float x;
nested scope|'$' stands outside of functions alone|move the declaration above the function
initializers must be constant|a const outside of functions has a constant value|set it in main()
integer expression required|an index is a whole number|write 0 for 0.0, or int(...)
sampler-constructor|a sampler is read by a function|write texture(s, uv)
call expected|this is called, and it is no function|write * to multiply
take any parameter|main takes no parameters|write: void main()
Recursion detected|'$' calls itself, which GLSL has not|write it as a loop
initialize this type|nothing but a variable or a const begins with a value|set a param's "default"
last case|the last case does nothing|add: break;
duplicated value|two cases have one value|take one of them out
statement only allowed|'break' and 'continue' stand in loops only|take it out, or write: return;
name too long|this name has more than 1024 characters|take a shorter one
beginning with "GL_"|names that begin with GL_ are GLSL's own|take another name
nest a structure|a struct is declared in another|declare it above
qualified as flat|whole numbers are not interpolated|write flat, in the vertex shader too: flat out
compile-time constant|an offset has to be constant|add it to the coordinate: uv + p * texel
value is out of range|an offset goes from -8 to 7|add it to the coordinate: uv + p * texel
Macro redefined|one macro has two #defines|write #undef before the second
args in|the macro takes another number of arguments|give as many as its #define
extension not supported|no device has this extension|leave it out
memory exhausted|this is nested too deep|make its expressions and blocks shorter
not supported|GLSL ES 3 has no '$'|leave it out
)";

/// What a function of GLSL takes, where it is called with something else.
constexpr std::pair<std::string_view, const char*> kArguments[] = {
    {"texelFetch", "the coordinate must be ivec2(...), and a level follows: texelFetch(s, p, 0)"},
    {"texture", "the coordinate must be vec2(...): texture(s, uv)"}};

/// What is written as in other languages: signs and words, and `type`, `name` and `value` for any
/// such, of which $ is the first. The error is at the token behind '@', or else in that statement.
constexpr std::string_view kPatterns = R"(
( type ) value|a value is converted by a call of the type|write $(...)
. size (|GLSL has no methods|write .length() of an array
. Sample (|GLSL has no methods|write texture(s, uv)
. sample (|GLSL has no methods|write texture(s, uv)
. name (|GLSL has no methods|write $(...) with the value inside
name ::|GLSL has no '$::'|write what stands behind it alone
? value @;|a '?' has no ':'|write x > 0.0 ? 1.0 : 0.0
=>|GLSL has no '=>'|write >=
**|GLSL has no '**'|write pow(a, b)
type @&|GLSL has no references|leave '&' out; write inout for a parameter that is changed
type @*|GLSL has no pointers|take an index, or an inout parameter
name @{|a variable does not begin with '{'|write: $ = ...;
type name @=|a parameter has no value of its own|take it out, and write a second function without it
type name @:|GLSL has no loop over elements|write for (int i = 0; i < 4; ++i)
= @[|a list is written as a call of its type|write float[](1.0, 2.0)
) ; @{|a ';' stands between a function and its body|take the ';' out
; @else|this 'else' follows no 'if'|put what the 'if' does in { }, with no ';' before it
} @else|this 'else' follows no 'if'|take out the ';' behind the condition
)";

bool isValue(const GlslToken& token)
{
    return token.kind == GlslToken::Kind::identifier || token.kind == GlslToken::Kind::number;
}

bool isName(const GlslToken& token) { return token.kind == GlslToken::Kind::identifier; }

bool isOneOf(const GlslToken& token, std::string_view signs)
{
    return token.text.size() == 1 && has(signs, token.text);
}

/// "vec3" for " temp highp 3-component vector of float".
std::string plainType(std::string_view type)
{
    const std::string_view scalar = type.substr(type.find_last_of(" }") + 1);
    const std::size_t vector = type.find("-component"), matrix = type.find(" matrix");
    if (has(type, "structure{")) return "a struct";
    if (const std::size_t size = type.find("-element array of "); size != type.npos) {
        const std::size_t begin = type.find_last_of(' ', size) + 1;
        return plainType(type.substr(size + 17)) + "[" +
               std::string(type.substr(begin, size - begin)) + "]";
    }
    if (matrix != type.npos && matrix > 0) return "mat" + std::string(1, type[matrix - 1]);
    if (vector == type.npos || vector == 0) return std::string(scalar);
    return (scalar == "float" ? "" : std::string(scalar.substr(0, 1))) + "vec" + type[vector - 1];
}

/// Whether the sign is none of GLSL's: $, @ or of another alphabet.
bool isForeign(const GlslToken& token)
{
    return token.kind == GlslToken::Kind::symbol &&
           !has("(){}[];,.:?=+-*/%<>!&|^~#\\", token.text.substr(0, 1));
}

bool isWhole(std::string_view type) { return type[0] == 'i' || type[0] == 'u'; }

/// "vec2" for "ivec2", "float" for "int".
std::string floatOf(const std::string& whole)
{
    return has(whole, "vec") ? whole.substr(1) : "float";
}

/// The texts in quotes that follow `lead`.
std::vector<std::string> typesAfter(std::string_view message, std::string_view lead)
{
    std::vector<std::string> types;
    for (std::size_t at = 0; (at = message.find(lead, at)) != message.npos;) {
        at += lead.size();
        types.push_back(plainType(message.substr(at, message.find('\'', at) - at)));
    }
    return types;
}

struct Speaker {
    const GlslStage& stage;
    const GlslTokens& tokens;
    Diagnostic& error;
    std::size_t at = 0;  ///< What the error points at; behind the last where at none.

    void run()
    {
        while (at < tokens.size() && !isHere(tokens[at])) ++at;
        const std::string message = error.message;
        if (at < tokens.size() && isForeign(tokens[at])) {
            const std::string_view line = lineOf(error.place.source->text, error.place.line);
            return say(characterName(line, std::size_t(error.place.column) - 1) +
                           " is no character of GLSL",
                       "take it out, or write what it stands for");
        }
        if (at < tokens.size() && pattern()) return;
        std::string name(quotedName(message));
        if (has(message, "can't modify") && at < tokens.size() && tokens[statement()].is("if"))
            return say("'=' writes, where a condition is wanted", "write == to compare");
        if (name == "assign" || name == "constructor" || name.empty())
            name = quotedName(message.substr(std::min(message.find(" : "), message.size())));
        if (has(message, "not return a value: ")) name = message.substr(message.rfind(' ') + 1);
        std::string feature;
        if (has(message, "' : not supported"))
            feature = message.substr(1, message.find_first_of("('", 1) - 1);
        feature.erase(feature.find_last_not_of(' ') + 1);
        if (name.empty()) name = has(message, "edefinition") ? nameHere(true) : feature;
        if (has(message, "syntax error") && at < tokens.size() && isName(tokens[at]))
            name = tokens[at].text;
        for (const std::string_view row : split(kElsewhere, '\n')) {
            const std::string names = "," + std::string(row.substr(0, row.find('|'))) + ",";
            if (!name.empty() && has(names, "," + name + ","))
                return say("GLSL ES 3 has no '" + name + "'",
                           "write " + std::string(row.substr(row.find('|') + 1)));
        }
        if (has(message, "syntax error")) return syntax(message);
        const bool call =
            has(message, "no matching overloaded") || has(message, "no function with");
        if (call || has(message, "undeclared") || has(message, "undefined variable"))
            return unknown(name, call);
        if (has(message, "of type '") || has(message, "cannot convert from '"))
            return types(message);
        if (startsWith(message, "'' : ")) error.message.erase(0, 5);
        tell(message, name.empty() ? nameHere(false) : name);
    }

    void say(std::string message, std::string help)
    {
        error.message = std::move(message);
        error.help = std::move(help);
    }

    void pointAt(const GlslToken& token) { error.place = placeOf(token, stage.files); }

    bool isHere(const GlslToken& token) const
    {
        return token.file >= 0 && stage.files[std::size_t(token.file)] == error.place.source &&
               token.line == error.place.line && token.column == error.place.column;
    }

    /// Says what a row has behind its first part, with the name for $.
    void sayRow(const std::vector<std::string_view>& row, std::string_view name)
    {
        say(std::string(row[1]), std::string(row[2]));
        for (std::string* text : {&error.message, &error.help})
            if (const std::size_t sign = text->find('$'); sign != text->npos)
                text->replace(sign, 1, name);
    }

    /// Whether the token is what a pattern's word stands for.
    bool fits(std::string_view word, std::size_t i) const
    {
        const GlslToken& token = tokens[i];
        if (word == "type") return findWord(kBuiltIn, token.text) < kBuiltIn.find("uniform");
        if (word == "name") return isName(token) && !token.is("length");
        if (word == "value") return isValue(token) || token.is("(");
        const bool here = word[0] == '@';
        return token.is(word.substr(here ? 1 : 0)) && (!here || i == at);
    }

    /// Whether the statement has one of kPatterns, at which the error then points.
    bool pattern()
    {
        constexpr std::size_t kBefore = 2;  // the end of the statement before
        const std::size_t first = statement();
        for (const std::string_view line : split(kPatterns, '\n')) {
            const std::vector<std::string_view> row = split(line, '|'), words = split(row[0], ' ');
            for (std::size_t i = first - std::min(first, kBefore);
                 row.size() == 3 && i <= at && i + words.size() <= tokens.size(); ++i) {
                std::size_t fitting = 0, named = i;
                for (std::size_t k = words.size(); k-- > 0 && fits(words[k], i + k); ++fitting)
                    if (isLower(words[k][0]) && isName(tokens[i + k])) named = i + k;
                if (fitting < words.size()) continue;
                if (row[0].find('@') == row[0].npos) pointAt(tokens[i]);
                sayRow(row, tokens[named].text);
                return true;
            }
        }
        return false;
    }

    /// How many of such brackets are open where the error is.
    int open(std::string_view sign, std::string_view end) const
    {
        int open = 0;
        for (std::size_t i = 0; i < at; ++i) open += tokens[i].is(sign) - tokens[i].is(end);
        return open;
    }

    void syntax(const std::string& message)
    {
        if (at == 0 || at >= tokens.size()) return;
        if (has(message, "end of file") || has(message, "$end")) return openBrace();
        const GlslToken& found = tokens[at];
        std::size_t before_at = at - 1;
        while (before_at > 0 && tokens[before_at].is("#")) --before_at;
        const GlslToken& last = tokens[before_at];
        const int depth = open("{", "}"), parens = open("(", ")");
        const bool value = isValue(last) || isOneOf(last, ")]");
        const std::string text(found.text), before(last.text);
        for (const auto& [sign, opens, count] :
             {std::tuple("}", "{", depth), std::tuple(")", "(", parens)})
            if (found.is(sign) && count <= 0)
                return say(
                    "this '" + text + "' closes nothing",
                    "take it out, or add the '" + std::string(opens) + "' that it is to close");
        if (depth > 0 && found.is("{") && last.is(")")) return openBrace();
        if (depth == 0 && isName(found) && !value && at + 1 < tokens.size() && (&found)[1].is("("))
            return say("function '" + text + "' has no return type",
                       "write: float " + text + "(...)");
        if (has(" if for while switch ", " " + before + " "))
            return say("a '(' is missing before '" + text + "'", "add '('");
        if (value && isValue(found) && last.line == found.line && text != "else")
            return say(
                "an operator or sign is missing between '" + before + "' and '" + text + "'",
                "add what is meant: " + std::string(parens > 0 ? "," : ";") + " + - * / ...");
        missing(message.substr(std::min(message.find("expecting"), message.size())), last, value);
    }

    /// By what the compiler wanted. A missing semicolon belongs to where it is missing, which is
    /// behind what the compiler read last.
    void missing(const std::string& wanted, const GlslToken& last, bool value)
    {
        const GlslToken& found = tokens[at];
        const std::string text(found.text), before(last.text);
        std::string expected;  // what is most likely meant first
        for (const auto& [name, sign] :
             {std::pair("RIGHT_PAREN", ")"), std::pair("RIGHT_BRACKET", "]"),
              std::pair("LEFT_PAREN", "("), std::pair("SEMICOLON", ";")})
            if (expected.empty() &&
                (has(wanted, name) || has(wanted, "'" + std::string(sign) + "'")))
                expected = sign;
        if (!expected.empty() && expected != ";" &&
            (isOneOf(found, ";{}") || last.line != found.line))
            return say("a '" + expected + "' is missing before '" + text + "'",
                       "add '" + expected + "'");
        if ((value || expected == ";") && (isValue(found) || found.is("}"))) {
            const bool body = open("{", "}") <= 0 && last.is(")") && !fits("type", at);
            expected = body ? "{" : ";";
            say("a '" + expected + "' is missing behind '" + before + "'",
                "add '" + expected + "'");
            pointAt(last);
            error.place.column += error.place.length;
            error.place.length = 1;
            return;
        }
        say("'" + text + "' cannot stand behind '" + before + "'",
            expected.empty() ? "no statement of GLSL has the two in a row"
                             : "glslang expects '" + expected + "' there");
    }

    /// The brace that does not close is the one whose line begins at another column than that of
    /// the brace which seems to close it.
    void openBrace()
    {
        std::vector<std::pair<const GlslToken*, int>> open;  // with the column of its line
        const GlslToken* guilty = nullptr;
        int column = 0;
        for (std::size_t i = 0; i <= at; ++i) {
            const GlslToken& token = tokens[i];
            const bool first = i == 0 || tokens[i - 1].line != token.line;
            if (first) column = token.column;
            if (token.is("{")) open.push_back({&token, column});
            if (!token.is("}") || open.empty()) continue;
            if (first && !guilty && column < open.back().second) guilty = open.back().first;
            open.pop_back();
        }
        if (open.empty())
            return say("the text ends too early", "complete what its last line begins");
        if (!guilty && tokens[at].is("{"))
            return say("a function begins inside of another", "add the '}' that is missing above");
        pointAt(guilty ? *guilty : *open.front().first);
        say("this '{' is not closed", "add '}' where what it opens ends");
    }

    /// Whether a type or the like stands before the name at `i`, 1 or more.
    bool isDeclared(std::size_t i) const
    {
        return isName(tokens[i]) && isName(tokens[i - 1]) && !tokens[i - 1].is("return");
    }

    /// Where the statement begins that the error is in.
    std::size_t statement() const
    {
        std::size_t i = std::min(at, tokens.size());
        while (i > 0 && !isOneOf(tokens[i - 1], ";{}")) --i;
        return i;
    }

    /// What an error is about that names nothing: a function, or the type behind which it points.
    std::string nameHere(bool function) const
    {
        std::size_t i = function ? statement() : at - 1;
        while (function && i + 1 < at && !tokens[i + 1].is("(")) ++i;
        return i < tokens.size() && isName(tokens[i]) ? std::string(tokens[i].text) : "this";
    }

    /// What is declared up to the error: for all, or in the function that it is in.
    std::vector<std::string> names() const
    {
        std::vector<std::string> names = stage.defines_used;
        for (const GlslUniform& uniform : stage.uniforms) names.push_back(uniform.name);
        for (const std::string_view name : split(kBuiltIn, ' ')) names.emplace_back(name);
        std::vector<std::string> local;
        int depth = 0;
        for (std::size_t i = 1; i < std::min(at, tokens.size()); ++i) {
            const GlslToken& token = tokens[i];
            depth += isOneOf(token, "({") - isOneOf(token, ")}");
            if (depth == 0 && isOneOf(token, ";}")) local.clear();
            if (isDeclared(i)) (depth > 0 ? local : names).emplace_back(token.text);
        }
        names.insert(names.end(), local.begin(), local.end());
        return names;
    }

    /// The functions of that name, as they are declared anywhere in the stage.
    std::string signatures(std::string_view name) const
    {
        std::string all;
        for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
            if (!tokens[i].is(name) || !isDeclared(i) || !tokens[i + 1].is("(")) continue;
            all += all.empty() ? "" : "; ";
            for (std::size_t k = i - 1; k < tokens.size() && !isOneOf(tokens[k], "{;"); ++k)
                all += (k >= i && isName(tokens[k]) && isName(tokens[k - 1]) ? " " : "") +
                       std::string(tokens[k].text) + (tokens[k].is(",") ? " " : "");
        }
        return all;
    }

    void unknown(const std::string& name, bool function)
    {
        const std::string declared = signatures(name);
        const std::vector<std::string_view> built_in = split(kBuiltIn, ' ');
        const bool known = std::find(built_in.begin(), built_in.end(), name) != built_in.end();
        const std::vector<std::string> usable = names();
        if (function && !declared.empty() && !contains(usable, name))
            return say("'" + name + "' is called above its declaration",
                       "move it up, or declare it above: " + declared + ";");
        std::string help = declared.empty() ? conversion("int", "float") : "declared: " + declared;
        for (const auto& [of, wanted] : kArguments)
            if (of == name) help = wanted;
        const std::string argument(at + 2 < tokens.size() ? tokens[at + 2].text : "");
        if (function && known && findNamed(stage.outputs, argument))
            help = "'" + argument +
                   "' is an output, which no pass reads: read a target as a uniform sampler2D";
        if (startsWith(help, "GLSL ES converts"))
            help = "their number, order, types and sizes must be as the function takes them";
        if (function && (known || !declared.empty()))
            return say("no '" + name + "' takes these arguments", help);
        if (known || !declared.empty())
            return say(
                "'" + name + "' is a function, and is not called",
                "write " + (known ? name + "(...)" : "its arguments behind it: " + declared));
        help = suggestName(name, usable, "");
        help.resize(has(help, "did you mean") ? help.find('?') + 1 : 0);
        if (help.empty()) help = "declare it, or include the file that does";
        if (contains(usable, name))
            help = "it is declared in another block: declare it before both";
        say("'" + name + "'" + std::string(kNotDeclared), help);
    }

    /// How to make `wanted` of `given`: by another form of the first whole number of the statement,
    /// if there is one.
    std::string conversion(const std::string& given, const std::string& wanted) const
    {
        for (std::size_t i = statement();
             given == "int" && i < tokens.size() && !isOneOf(tokens[i], ";{}"); ++i) {
            const std::string text(tokens[i].text);
            const bool whole = text.find_first_not_of("0123456789") == text.npos;
            if (!whole || i == 0 || tokens[i - 1].is("[")) continue;
            return "write " + text + (wanted == "uint" ? "u" : ".0") + " for " + text +
                   ": GLSL ES converts nothing by itself";
        }
        if (startsWith(given, "sampler")) return "write texture(s, uv), which reads it";
        if (given == "void") return "let the function return " + wanted;
        if (has(given, "vec") && !isWhole(given) && (wanted < given || !has(wanted, "vec")))
            return "take as many of its components as are wanted: .x, .xy or .xyz";
        return "GLSL ES converts nothing by itself: write " + wanted + "(...)";
    }

    void types(const std::string& message)
    {
        const std::vector<std::string> operands = typesAfter(message, "operand of type '");
        const std::vector<std::string> from = typesAfter(message, "cannot convert from '");
        const std::vector<std::string> to = typesAfter(message, "' to '");
        const std::string sign = message.substr(message.find('\'') + 1, message.find("' ") - 1);
        const std::string compare = sign[0] == '<'   ? "lessThan"
                                    : sign[0] == '>' ? "greaterThan"
                                                     : "";
        if (operands.size() == 2)
            say("'" + sign + "' does not take " + operands[0] + " and " + operands[1],
                sign == "<<" || sign == ">>" ? "shift a whole number by a whole number"
                : sign == "^"                ? "write pow(a, b)"
                : sign == "&&" || sign == "||" || sign == "^^" ? "compare what is no bool: x > 0.0"
                : !compare.empty() && operands[0] == "bool"    ? "write a < b && b < c"
                : !compare.empty() && has(operands[0], "vec")
                    ? "compare by component: any(" + compare + "(a, b))"
                : operands[0] == operands[1] ? "it is for other types; % of floats is mod(a, b)"
                : contains(operands, "bool") ? "write float(...) around what is true or false"
                : isWhole(operands[0]) && isWhole(operands[1])
                    ? conversion(operands[0], operands[1])
                : isWhole(operands[0]) ? conversion(operands[0], floatOf(operands[0]))
                : isWhole(operands[1]) ? conversion(operands[1], floatOf(operands[1]))
                                       : "bring both to one size: float(...), vec4(v, 1.0), .xyz");
        else if (!from.empty() && !to.empty())
            say("this is " + from[0] + ", wanted " + to[0], conversion(from[0], to[0]));
    }

    /// By kMessages; and where the first of two declarations is.
    void tell(const std::string& message, const std::string& name)
    {
        const bool twice = has(message, "' : redefinition") || has(message, "already has a body") ||
                           has(message, "function syntax");
        for (std::size_t i = twice ? std::min(at, tokens.size()) : 0; i-- > 1;)
            if (tokens[i].is(name) && isDeclared(i) && error.notes.empty())
                error.notes.push_back({placeOf(tokens[i], stage.files), "it is declared here too"});
        for (const std::string_view row : split(kMessages, '\n')) {
            const std::vector<std::string_view> parts = split(row, '|');
            if (parts.size() == 3 && has(message, parts[0])) return sayRow(parts, name);
        }
    }
};

}  // namespace

void sayPlainly(const GlslStage& stage, const GlslTokens& tokens, Diagnostic& error)
{
    Speaker{stage, tokens, error}.run();
}

}  // namespace crevice
