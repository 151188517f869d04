// SPDX-License-Identifier: MIT
// What fails at each of its calls in turn: anything, and changes of a running renderer.
//
// A device has failAt(n), which makes the n-th coming call that creates or fills an object fail,
// attempts(), which counts such calls, and live(), which counts the objects: RecordingDevice.
// WatchedGl has the first two for the calls of a driver.
#pragma once

#include <crevice/renderer.h>

#include "tests/support/need.h"

#include <functional>
#include <string>
#include <vector>

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

/// What a host may change, so that all is planned again.
struct Change {
    const char* what;
    std::function<Status(Renderer&, Frame&)> make;
    bool draws = false;  ///< A frame is drawn as it is made.
};

inline Change resizing()
{
    return {"a size", [](Renderer& renderer, Frame&) { return renderer.resize({40, 22}); }};
}

inline Change reloading(const Description& other)
{
    return {"a reload", [other](Renderer& renderer, Frame&) {
                return renderer.reload(other, {renderer.plan().extent});
            }};
}

inline Change moreLights()
{
    return {"lights",
            [](Renderer& renderer, Frame& frame) {
                Frame other = frame;
                other.lights.resize(other.lights.size() + 2);
                Status status = renderer.render(other);
                if (status.ok()) frame = other;
                return status;
            },
            true};
}

/// The first param that is bound as a define, set to its least value.
inline Change defining()
{
    return {"a define", [](Renderer& renderer, Frame&) -> Status {
                for (const ParamDesc& param : renderer.description().params)
                    if (param.bind == Bind::define && param.type == ParamType::int_)
                        return renderer.setParam(param.name, static_cast<float>(param.min));
                return {};
            }};
}

/// Makes each change, failing each of its objects. `shown` returns what the outputs hold, and
/// `draw` what a frame of the renderer came to: in the end the same as of one that never failed.
template <class FailingDevice, class Draw, class Shown>
void checkFailingChanges(FailingDevice& device, Renderer& renderer, Frame frame,
                         const std::vector<Change>& changes, const Draw& draw, const Shown& shown)
{
    draw(renderer, frame);
    for (const Change& change : changes) {
        INFO(change.what);
        const auto before = shown(renderer);
        const int failures = failEachObject(
            device, [&] { return change.make(renderer, frame); },
            [&] { CHECK((shown(renderer) == before)); });
        if (failures == 0) continue;  // nothing to change
        auto fresh = need(Renderer::create(device, renderer.description(), {renderer.plan().extent},
                                           traitsOf(frame)));
        if (change.draws) draw(*fresh, frame);
        CHECK((draw(renderer, frame) == draw(*fresh, frame)));
    }
}

}  // namespace crevice
