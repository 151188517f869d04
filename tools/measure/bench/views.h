// SPDX-License-Identifier: MIT
// Which bench samples can be compared with each other: those that show the same view on one device.
#pragma once

#include "tools/measure/bench/sample.h"

namespace crevice {

/// Samples with the same ground truth and the same clockwork. Failed samples are in no view.
struct ResultView {
    std::string device;
    std::string scene;
    std::string camera;
    Extent extent;
    double radius = 0;
    std::string clock;                      ///< As BenchSample has it.
    std::vector<std::size_t> samples = {};  ///< Indexes, in the order of the results.
    /// The scene; with its camera where it was seen from several.
    std::string name = {};
};

/// Sorted by device, scene and camera; of one scene and camera the view with the most samples
/// first.
std::vector<ResultView> benchViews(const std::vector<BenchSample>& samples);

/// One view of each scene and camera on a device: at the extent that most samples share, then the
/// radius that most samples share. Sweeps of size and radius are thus kept out of a choice
/// between configs. An extent that is not 0x0 is the one to take.
std::vector<ResultView> mainViews(const std::vector<ResultView>& views, const std::string& device,
                                  Extent extent = {});

/// The devices in the order of their first samples.
std::vector<std::string> benchDevices(const std::vector<BenchSample>& samples);

/// "room from above", or "room" where the camera has no name.
std::string viewName(const std::string& scene, const std::string& camera);

}  // namespace crevice
