// SPDX-License-Identifier: MIT
// What fails at each of its calls in turn.
//
// A device has failAt(n), which makes the n-th coming call that creates or fills an object fail,
// attempts(), which counts such calls, and live(), which counts the objects: RecordingDevice.
// WatchedGl has the first two for the calls of a driver.
#pragma once

#include "tests/support/need.h"

#include <functional>

namespace crevice {

/// Does `work` with each of its attempts failing, up to one run that makes fewer, and calls
/// `failed` with what each run came to. Returns how many attempts there were.
template <class Faulty>
int failEachAttempt(Faulty& faulty, const std::function<Status()>& work,
                    const std::function<void(const Status&)>& failed)
{
    for (int n = 1;; ++n) {
        INFO("attempt " << n);
        const int attempts = faulty.attempts();
        faulty.failAt(n);
        const Status status = work();
        faulty.failAt(0);
        if (faulty.attempts() - attempts < n) {
            need(status);
            return n - 1;
        }
        INFO(toText(status.diagnostics()));
        failed(status);
    }
}

/// Does `change` with each of its objects failing, up to one run that meets no failure. Where it
/// failed nothing is left behind, and `unchanged` is called. Returns how often it failed.
template <class FailingDevice>
int failEachObject(FailingDevice& device, const std::function<Status()>& change,
                   const std::function<void()>& unchanged)
{
    const int live = device.live();
    for (int n = 1;; ++n) {
        INFO("object " << n);
        device.failAt(n);
        const Status status = change();
        device.failAt(0);
        if (status.ok()) return n - 1;
        REQUIRE(status.diagnostics().size() == 1);
        CHECK(status.diagnostics()[0].code == Code::out_of_memory);
        REQUIRE(device.live() == live);
        unchanged();
    }
}

}  // namespace crevice
