// SPDX-License-Identifier: MIT
// Ray-traced references, kept on disk: tracing one takes seconds, reading it milliseconds.
//
// A file is named after a hash over everything that decides its pixels, so that it never goes
// stale; any of them may be deleted at any time.
#pragma once

#include "tools/measure/reference/tracer.h"

namespace CLI {
class App;
}

namespace crevice {

struct CacheOptions {
    std::string folder;  ///< --cache; empty for the usual one.
    bool off = false;    ///< --no-cache

    /// Where references are kept: --cache, $XDG_CACHE_HOME/crevice or ~/.cache/crevice. Empty for
    /// nowhere.
    std::string path() const;
};

/// $XDG_CACHE_HOME/crevice or ~/.cache/crevice; empty where neither variable is set.
std::string usualCacheFolder();

/// Adds --cache and --no-cache.
void addCacheOptions(CLI::App& app, CacheOptions& options);

/// A hash over the scene's triangles and cut-outs, the camera's matrices, the size, the radius, the
/// number of rays and the tracer's version: 16 hex digits.
std::string referenceKey(const Scene& scene, const Camera& camera, Extent extent,
                         const TraceOptions& options);

/// The picture of `traceAmbientOcclusion`, from the folder where it is there; otherwise it is
/// traced and kept there, with a checksum behind the PFM. A file that was changed and a folder that
/// cannot be written are warnings. An empty name: no folder.
///
/// Errors: CV7008 when the camera sees no surface, and those of `traceAmbientOcclusion`.
Result<Image> cachedReference(const Scene& scene, const Camera& camera, Extent extent,
                              const TraceOptions& options, const std::string& cache_folder);

}  // namespace crevice
