// SPDX-License-Identifier: MIT
// A header that a host may have: crevice must include its own.
#error "crevice included a header of its host"
