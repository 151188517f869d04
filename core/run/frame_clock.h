// SPDX-License-Identifier: MIT
// The clock that frames are timed by where no GPU's timer does.
#pragma once

#include <crevice/frame.h>

namespace crevice {

/// Take its time, draw, wait with Device::finish, and take it again.
///
/// On a software renderer it counts the processor time of the process, all threads together: there
/// the drawing is done by threads of this process, and what else the machine does hardly counts.
/// Elsewhere, and on platforms that do not tell the processor time, it is a steady wall clock.
class FrameClock {
public:
    /// `software` as DeviceCaps has it.
    explicit FrameClock(bool software);

    TimingMethod method() const { return method_; }

    /// Milliseconds since some moment that stays the same.
    double now() const;

private:
    TimingMethod method_;
};

}  // namespace crevice
