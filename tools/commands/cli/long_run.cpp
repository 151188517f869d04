// SPDX-License-Identifier: MIT
#include "tools/commands/cli/long_run.h"

#include <csignal>

#include <chrono>

namespace crevice {
namespace {

volatile std::sig_atomic_t signalled = 0;

}  // namespace

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

}  // namespace crevice
