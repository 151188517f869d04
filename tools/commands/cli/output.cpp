// SPDX-License-Identifier: MIT
#include "tools/commands/cli/output.h"

#include "core/base/text.h"
#include "tools/render/image/image_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace fs = std::filesystem;

namespace crevice {
namespace {

volatile std::sig_atomic_t signalled = 0;
int output_failure = 0;  // the errno of the first write to stdout that failed

std::string formatted(const char* format, std::va_list values)
{
    std::va_list again;
    va_copy(again, values);
    std::string text(
        static_cast<std::size_t>(std::max(std::vsnprintf(nullptr, 0, format, again), 0)), '\0');
    va_end(again);
    std::vsnprintf(text.data(), text.size() + 1, format, values);
    return text;
}

void note(bool written)
{
    if (!written && output_failure == 0) output_failure = errno;
}

/// What was printed before a message is seen before it.
void put(std::FILE* stream, const std::string& text)
{
    if (stream == stderr) note(std::fflush(stdout) == 0);
    const bool written = std::fputs(printable(text).c_str(), stream) >= 0;
    if (stream == stdout) note(written);
}

Diagnostic unwritable(const std::string& file, const std::string& reason, std::string help)
{
    return {Code::cannot_write, "'" + file + "' cannot be written: " + reason, std::move(help)};
}

/// Whether %d or %0Nd, with N of 1 to 9, begins there.
bool isFramePlace(const std::string& pattern, std::size_t at)
{
    if (pattern.compare(at, 2, "%d") == 0) return true;
    return pattern.size() >= at + 4 && pattern[at + 1] == '0' && pattern[at + 2] >= '1' &&
           pattern[at + 2] <= '9' && pattern[at + 3] == 'd';
}

using Json = nlohmann::ordered_json;

/// A value on one line.
std::string cellOf(const Json& value)
{
    if (value.empty()) return "-";
    if (value.is_boolean()) return value ? "yes" : "no";
    if (value.is_string()) return printableLine(value.get<std::string>());
    if (value.is_number_float()) return significant(value, 6);
    if (!value.is_structured()) return value.dump();
    std::vector<std::string> parts;
    for (const auto& [name, each] : value.items())
        parts.push_back((value.is_object() ? name + ' ' : "") + cellOf(each));
    return joined(parts, value.is_array() && value[0].is_number() ? " " : ", ");
}

/// Cells below their keys, in columns.
std::string tableOf(const Json& objects)
{
    std::map<std::string, std::size_t> widths;
    for (const Json& each : objects)
        for (const auto& [key, value] : each.items())
            widths[key] = std::max({widths[key], key.size(), cellOf(value).size()});
    std::string text;
    const auto add = [&](const std::string& key, const std::string& cell) {
        text += "  " + cell + std::string(widths[key] - cell.size(), ' ');
    };
    const auto endLine = [&text] { text = text.substr(0, text.find_last_not_of(' ') + 1) + '\n'; };
    for (const auto& [key, value] : objects.front().items())
        if (key != "help") add(key, key);
    endLine();
    for (const Json& each : objects) {
        for (const auto& [key, value] : each.items())
            if (key != "help") add(key, cellOf(value));
        endLine();
        if (each.contains("help")) text += "      " + cellOf(each["help"]) + '\n';
    }
    return text;
}

}  // namespace

int exitCodeOf(const Diagnostics& diagnostics)
{
    const auto error =
        std::find_if(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
    if (error == diagnostics.end()) return kExitOk;
    switch (error->code) {
    case Code::usage: return kExitUsage;
    case Code::cannot_write: return kExitOutput;
    case Code::no_egl:
    case Code::no_osmesa:
    case Code::gl_function:
    case Code::gl_version:
    case Code::gl_error:
    case Code::no_format:
    case Code::too_many:
    case Code::out_of_memory:
    case Code::context_lost:
    case Code::no_compilers:
    case Code::cannot_serve:
    case Code::page_missing:
    case Code::no_backend: return kExitMachine;
    default: return kExitBadInput;
    }
}

void print(const char* format, ...)
{
    std::va_list values;
    va_start(values, format);
    put(stdout, formatted(format, values));
    va_end(values);
}

void printLines(const std::string& text) { put(stdout, text); }

void printAsJson(const nlohmann::json& json)
{
    put(stdout, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
}

void printTables(const Json& json)
{
    for (const auto& [key, value] : json.items()) {
        const bool list = value.is_array(), table = list && !value.empty() && value[0].is_object();
        std::string head = key + (list ? " (" + std::to_string(value.size()) + ")" : "");
        if (!table) head.resize(std::max<std::size_t>(head.size(), 14), ' ');
        printLines(head + (table ? '\n' + tableOf(value) : "  " + cellOf(value) + '\n'));
    }
}

void printMessage(const char* format, ...)
{
    std::va_list values;
    va_start(values, format);
    put(stderr, formatted(format, values));
    va_end(values);
}

void reserveStreams()
{
    for (int file = STDIN_FILENO; file <= STDERR_FILENO; ++file)
        if (fcntl(file, F_GETFD) < 0)
            open("/dev/null", O_RDONLY);  // the lowest free number: this one
}

int finishOutput(int exit_code)
{
    note(std::fflush(stdout) == 0);
    if (output_failure == 0 && std::ferror(stdout) == 0) return exit_code;
    if (output_failure == EPIPE) return kExitOutput;
    std::string message =
        "the output cannot be written";  // CLI11 prints help by itself and keeps no reason
    if (output_failure != 0) message += std::string(": ") + std::strerror(output_failure);
    report({{Code::cannot_write, message, "make room, or write to another place"}}, false);
    return kExitOutput;
}

int report(const Diagnostics& diagnostics, bool json)
{
    if (diagnostics.empty()) return kExitOk;
    if (json)
        printLines("{\"diagnostics\": " + toJson(diagnostics) + "}\n");
    else
        put(stderr, toText(diagnostics));
    return exitCodeOf(diagnostics);
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { wipe(); }

void Progress::begin(std::string what)
{
    what_ = printableLine(what);
    percent_ = -1;
    next_s_ = std::max(next_s_, clockSeconds() + 2);
    wipe();
    if (terminal_) std::fprintf(stderr, "%s ...", what_.c_str());
}

void Progress::update(double done, const char* part)
{
    const int percent = static_cast<int>(done * 100.0);
    if (percent == percent_ || (!terminal_ && clockSeconds() < next_s_)) return;
    percent_ = percent;
    next_s_ = clockSeconds() + 10;
    wipe();
    std::fprintf(stderr, "%s%s ... %d %%%s", what_.c_str(), part, percent, terminal_ ? "" : "\n");
}

void Progress::wipe()
{
    if (terminal_) std::fputs("\r\033[K", stderr);
}

void catchInterrupts()
{
    struct sigaction action = {};
    action.sa_handler = [](int) { signalled = 1; };
    action.sa_flags = SA_RESETHAND;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return signalled != 0; }

double clockSeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

Result<NamedFile> parseOutputRequest(const std::string& text)
{
    const auto is_file = [](const std::string& file) {
        const std::string extension = lowerExtension(file);
        return extension == ".png" || extension == ".pfm" || extension == ".exr";
    };
    if (!text.empty() && !has(text, "=") && !is_file(text)) return NamedFile{text, ""};
    Result<NamedFile> request =
        parseNamedFile("--out", text, "write --out color=lit.png or --out ao=ao.pfm");
    if (request && !is_file(request->file))
        return Diagnostic{
            Code::usage, "the file '" + request->file + "' of --out is none of .png, .pfm and .exr",
            "PNG holds 8 bits a channel for looking at, PFM and EXR 32-bit floats"};
    return request;
}

std::string frameFile(const std::string& pattern, int frame)
{
    const std::size_t at = pattern.find('%'), end = pattern.find('d', at) + 1;
    const std::size_t digits = end - at == 4 ? pattern[at + 2] - '0' : 1;
    std::string number = std::to_string(frame);
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    return pattern.substr(0, at) + number + pattern.substr(end);
}

Status checkFramePattern(const std::string& file)
{
    const std::size_t at = file.find('%');
    if (at != file.npos && isFramePlace(file, at) && file.find('%', at + 1) == file.npos) return {};
    return Diagnostic{
        Code::usage,
        file.empty() ? "an --out names no file for the frames"
                     : "the file '" + file + "' of --out has not one place for the frame's number",
        "with --path write --out ao=frame_%03d.png, with one %d or %03d"};
}

Status checkWritable(const std::string& file)
{
    const fs::path target = behindLinks(file);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        return unwritable(file, "there is no folder '" + folder.string() + "'",
                          file[0] == '~' ? "write $HOME for '~', which no shell replaces behind '='"
                                         : "mkdir -p '" + folder.string() + "'");
    if (fs::is_directory(file, ignored))
        return unwritable(file, "it is a folder", "give a file's name");
    if (access(folder.c_str(), W_OK) != 0)
        return unwritable(file, "the folder '" + folder.string() + "' cannot be written",
                          "choose another folder");
    return {};
}

}  // namespace crevice
