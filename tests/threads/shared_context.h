// SPDX-License-Identifier: MIT
// A context of the host's own that shares textures with another, for tests of contexts.
#pragma once

#include <memory>
#include <string>

namespace crevice {

class SharedContext {
public:
    /// Shares with the context that is current, of that backend ("egl" or "osmesa"), and leaves it
    /// current. Null where the backend's library gives none.
    static std::unique_ptr<SharedContext> make(const std::string& backend);

    virtual ~SharedContext() = default;

    /// Makes it current on this thread; false where that fails.
    virtual bool makeCurrent() = 0;
};

}  // namespace crevice
