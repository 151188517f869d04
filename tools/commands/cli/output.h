// SPDX-License-Identifier: MIT
// What the crevice command says: diagnostics, exit codes, progress; and, for work that takes long,
// a clock and an end in good order.
#pragma once

#include <crevice/diagnostic.h>

#include <nlohmann/json_fwd.hpp>

namespace crevice {

/// How the command ends; docs/reference/command_line.md explains each.
enum ExitCode {
    kExitOk = 0,
    kExitBadInput = 1,  ///< A config, scene, image or value is wrong.
    kExitUsage = 2,     ///< The arguments cannot be understood.
    kExitMachine = 3,   ///< The machine lacks something: no context, no float target, no memory.
    kExitOutput = 4,    ///< A result cannot be written.
    /// `compare`, `compare-bench`, `cost`: over a limit; `doctor`: a pass is wrong; `stress`: a
    /// step is worse than known; `test`: a check failed.
    kExitDiffers = 5,
    kExitInterrupted = 130,  ///< `bench`, `test`: stopped by SIGINT or SIGTERM; can go on.
};

/// The exit code that stands for the first error; kExitOk when there are only warnings.
int exitCodeOf(const Diagnostics& diagnostics);

/// Prints to stdout, as printf does, but printable: no text of a file controls the terminal. All
/// output of the command goes through this and the three below.
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);

/// Prints lines as they are, but printable.
void printLines(const std::string& text);

/// Prints JSON, indented.
void printAsJson(const nlohmann::json& json);

/// Prints JSON for people, a list of objects as a table with the "help" of each below it.
void printTables(const nlohmann::ordered_json& json);

/// As print, to stderr.
[[gnu::format(printf, 1, 2)]] void printMessage(const char* format, ...);

/// Opens what is closed of standard input, output and error, so that no file of ours gets its
/// number and with it what is printed. Writing to it still fails. Before anything else is opened.
void reserveStreams();

/// Ends what was printed to stdout. Returns `exit_code`, or kExitOutput, after one message, where
/// some of it could not be written; a closed pipe is no error.
int finishOutput(int exit_code);

/// Prints to stderr as text or, for programs, to stdout as {"diagnostics": [...]}. Prints nothing
/// for an empty list. Returns `exitCodeOf`.
int report(const Diagnostics& diagnostics, bool json);

/// One line on a terminal that says what long work is at; the destructor wipes it. Where stderr is
/// no terminal, a line of its own once work with a percentage has taken two seconds, and every ten.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Names what comes next: "drawing".
    void begin(std::string what);

    /// How far it is, [0, 1], with `part` in what was begun. Cheap to call often: prints only when
    /// the whole percentage changes.
    void update(double done, const char* part = "");

    /// Wipes the line, so that something else can be printed.
    void wipe();

private:
    std::string what_;
    int percent_ = 0;
    bool terminal_;
    double next_s_ = 0;  ///< When there may be another line, by clockSeconds.
};

/// From here on the first interrupt (SIGINT, SIGTERM) only sets `interrupted`, a second one ends
/// the program at once. A file over the limit that the shell sets (ulimit -f) is an error like a
/// full disk's and does not kill the program.
void catchInterrupts();

bool interrupted();

/// Seconds of a steady clock, from an arbitrary start.
double clockSeconds();

/// NAME=FILE of the command line.
struct NamedFile {
    std::string name;
    std::string file;
};

/// Reads the text of an option. Errors: CV8001 with `help` where either side of the first '=' is
/// missing.
inline Result<NamedFile> parseNamedFile(const char* option, const std::string& text,
                                        std::string help)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        return Diagnostic{Code::usage, option + (" '" + text) + "' is not NAME=FILE",
                          std::move(help)};
    return NamedFile{text.substr(0, equals), text.substr(equals + 1)};
}

/// What `crevice render --out NAME=FILE` asks for: an output, a debug view or any target, in a
/// .png, .pfm or .exr; or with NAME alone, and an empty file, one that is a number, to be printed.
/// Errors: those of `parseNamedFile`; CV8001 for a file of another kind.
Result<NamedFile> parseOutputRequest(const std::string& text);

/// The file of a frame, [0, ...): "frame_%03d.png" gives "frame_007.png". `pattern` is one that
/// checkFramePattern accepts.
std::string frameFile(const std::string& pattern, int frame);

/// Errors: CV8001 for a file without one place for the frame's number, written %d or %03d.
Status checkFramePattern(const std::string& file);

/// Checks that a file can be written, before any work is done.
/// Errors: CV7007 for a folder that does not exist or is not writable, and for a file that is a
/// folder.
Status checkWritable(const std::string& file);

}  // namespace crevice
