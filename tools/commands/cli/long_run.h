// SPDX-License-Identifier: MIT
// What commands that run for long share: a clock, and an end in good order.
#pragma once

namespace crevice {

/// From here on the first interrupt (SIGINT, SIGTERM) only sets `interrupted`, a second one ends
/// the program at once. A file over the limit that the shell sets (ulimit -f) is an error like a
/// full disk's and does not kill the program.
void catchInterrupts();

bool interrupted();

/// Seconds of a steady clock, from an arbitrary start.
double clockSeconds();

}  // namespace crevice
