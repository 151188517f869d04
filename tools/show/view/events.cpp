// SPDX-License-Identifier: MIT
#include "tools/show/view/events.h"

#include <algorithm>

namespace crevice {

namespace {
constexpr std::size_t kKept = 64;  // one holds a file, of 1 MiB at most
}

void Events::push(const std::string& name, const std::string& data)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    kept_.push_back("event: " + name + "\ndata: " + data + "\n\n");
    if (kept_.size() > kKept) kept_.pop_front();
    ++count_;
    came_.notify_all();
}

void Events::close()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    came_.notify_all();
}

std::uint64_t Events::count() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return count_;
}

std::optional<std::string> Events::next(std::uint64_t& seen, std::chrono::milliseconds wait)
{
    std::unique_lock<std::mutex> lock(mutex_);
    came_.wait_for(lock, wait, [&] { return closed_ || count_ > seen; });
    if (closed_) return std::nullopt;
    if (count_ <= seen) return "";
    seen = std::max(seen, count_ - kept_.size());
    const std::size_t index = kept_.size() - static_cast<std::size_t>(count_ - seen);
    ++seen;
    return kept_[index];
}

}  // namespace crevice
