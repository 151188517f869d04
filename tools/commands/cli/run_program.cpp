// SPDX-License-Identifier: MIT
#include "tools/commands/cli/run_program.h"

#include "core/base/numbers.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>

extern char** environ;

namespace crevice {

namespace {

using Clock = std::chrono::steady_clock;

/// A file descriptor that closes itself.
class File {
public:
    explicit File(int number = -1) : number_(number) {}
    ~File() { close(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    int number() const { return number_; }
    void close()
    {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

/// A file without a name that holds the text, at its beginning; -1 where there is none. A pipe
/// could block: the program may print before it has read all.
int fileOf(const std::string& text)
{
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "crevice.XXXXXX").string();
    const int file = mkostemp(name.data(), O_CLOEXEC);
    if (file < 0) return -1;
    unlink(name.c_str());
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t count = write(file, text.data() + at, text.size() - at);
        if (count <= 0) {
            ::close(file);
            return -1;
        }
        at += static_cast<std::size_t>(count);
    }
    lseek(file, 0, SEEK_SET);
    return file;
}

/// This process's variables, but for those that `variables` sets, and these.
std::vector<std::string> environmentWith(const std::vector<std::string>& variables)
{
    const auto nameOf = [](const std::string& text) { return text.substr(0, text.find('=') + 1); };
    std::vector<std::string> all = variables;
    for (char** each = environ; *each; ++each) {
        const std::string name = nameOf(*each);
        if (std::none_of(variables.begin(), variables.end(),
                         [&](const std::string& set) { return nameOf(set) == name; }))
            all.push_back(*each);
    }
    return all;
}

/// Starts the program, whose descriptors 0, 1 and 2 these become. The error number, or 0.
int start(const std::string& path, const std::vector<std::string>& variables, int input, int output,
          pid_t& process)
{
    std::vector<std::string> environment = environmentWith(variables);
    std::vector<char*> pointers;
    for (std::string& each : environment) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    std::string name = path;
    char* arguments[] = {name.data(), nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    const int error =
        posix_spawn(&process, path.c_str(), &actions, nullptr, arguments, pointers.data());
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/// Reads until the other end is closed. False where the time is up before.
bool readAll(int file, Clock::time_point deadline, std::string& text)
{
    char buffer[1 << 16];
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return false;
        pollfd waited = {file, POLLIN, 0};
        if (poll(&waited, 1, static_cast<int>(left)) <= 0) continue;
        const ssize_t count = read(file, buffer, sizeof buffer);
        if (count <= 0) return true;
        text.append(buffer, static_cast<std::size_t>(count));
    }
}

}  // namespace

ProgramRun runProgram(const std::string& path, const std::vector<std::string>& variables,
                      const std::string& input, double time_s)
{
    ProgramRun run;
    int ends[2];
    const File text(fileOf(input));
    if (text.number() < 0 || pipe2(ends, O_CLOEXEC) != 0) {
        run.failure = "there is no file or no pipe for it";
        return run;
    }
    const File out(ends[0]);
    File in(ends[1]);
    pid_t process = -1;
    if (const int error = start(path, variables, text.number(), in.number(), process)) {
        run.failure = std::string("it cannot be started: ") + std::strerror(error);
        return run;
    }
    in.close();
    const auto limit =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_s));
    const bool in_time = readAll(out.number(), Clock::now() + limit, run.output);
    if (!in_time) kill(process, SIGKILL);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    if (!in_time)
        run.failure = "it ran for more than " + fixed(time_s, 1) + " s";
    else if (!WIFEXITED(status))
        run.failure = "it was ended by signal " + std::to_string(WTERMSIG(status));
    run.ended = run.failure.empty();
    if (run.ended) run.exit_code = WEXITSTATUS(status);
    return run;
}

}  // namespace crevice
