// SPDX-License-Identifier: MIT
// Work dealt out to all processors.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace crevice {

/// Calls `work(item)` for each item of [0, count), dealt out one by one to `threads` threads, this
/// one among them; 0 takes one a processor. Returns when all is done. In the browser, where
/// threads cannot be had, this one does it all.
template <class Work>
void onProcessors(int threads, int count, const Work& work)
{
    std::atomic<int> next = 0;
    const auto take = [&] {
        for (int item = next++; item < count; item = next++) work(item);
    };
#ifdef __EMSCRIPTEN__
    threads = 1;
#endif
    const unsigned all = threads > 0 ? threads : std::thread::hardware_concurrency();
    std::vector<std::thread> helpers;
    for (unsigned k = 1; k < all; ++k) helpers.emplace_back(take);
    take();
    for (std::thread& helper : helpers) helper.join();
}

}  // namespace crevice
