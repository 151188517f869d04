// SPDX-License-Identifier: MIT
#include "tools/measure/matrix/jobs.h"

#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace crevice {
namespace {

struct Job {
    pid_t process = -1;
    int file = -1;
    std::string text = {};  // of a line that has not ended
};

/// False where there is no process or no pipe; errno says why.
bool start(Job& job, int number, const std::vector<Job>& others,
           const std::function<void(int, SendLine)>& work)
{
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) return false;
    job.process = fork();
    if (job.process != 0) {
        close(ends[1]);
        job.file = ends[0];
        return job.process > 0;
    }
    for (const Job& other : others) close(other.file);
    close(ends[0]);
    try {
        work(number, [file = ends[1]](const std::string& line) {
            if (writeAll(file, line + "\n") != 0) _exit(1);
        });
    } catch (...) {
        _exit(1);
    }
    _exit(0);
}

/// Takes what has arrived of a job; closes its file where nothing more comes.
void receive(Job& job, const std::function<void(const std::string&)>& take)
{
    char part[1 << 16];
    const ssize_t count = read(job.file, part, sizeof(part));
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) {
        close(job.file);
        job.file = -1;
        return;
    }
    job.text.append(part, static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = job.text.find('\n')) != std::string::npos;) {
        take(job.text.substr(0, end));
        job.text.erase(0, end + 1);
    }
}

std::string endOf(const Job& job)
{
    int status = 0;
    while (waitpid(job.process, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status))
        return "a process was ended by signal " + std::to_string(WTERMSIG(status));
    return WEXITSTATUS(status) == 0 ? "" : "a process ended before it was done";
}

}  // namespace

std::vector<std::string> runJobs(int count, const std::function<void(int, SendLine)>& work,
                                 const std::function<void(const std::string&)>& take)
{
    std::vector<Job> jobs;
    std::vector<std::string> failures;
    for (int number = 0; number < count; ++number) {
        Job job;
        if (start(job, number, jobs, work))
            jobs.push_back(job);
        else
            failures.push_back(std::string("no process can be started: ") + std::strerror(errno));
    }
    bool told = false;
    for (;;) {
        if (interrupted() && !told)
            for (const Job& job : jobs) kill(job.process, SIGTERM);
        told = interrupted();
        std::vector<pollfd> files;
        for (const Job& job : jobs)
            if (job.file >= 0) files.push_back({job.file, POLLIN, 0});
        if (files.empty()) break;
        if (poll(files.data(), files.size(), 1000) <= 0) continue;
        for (const pollfd& file : files)
            for (Job& job : jobs)
                if (file.revents != 0 && job.file == file.fd) receive(job, take);
    }
    for (const Job& job : jobs)
        if (std::string end = endOf(job); !end.empty()) failures.push_back(std::move(end));
    return failures;
}

}  // namespace crevice
