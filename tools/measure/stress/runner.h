// SPDX-License-Identifier: MIT
// Drawing the steps of stress cases on a device, in memory full of NaN, and looking at every
// target.
#pragma once

#include "tools/measure/stress/record.h"
#include "tools/measure/stress/scenes.h"
#include "tools/render/host_textures.h"
#include "tools/render/read_output.h"

namespace crevice {

/// One step of one config.
struct StressTask {
    ConfigOptions config;
    const StressCase* stress = nullptr;
    int step = 0;
};

/// What a step showed.
struct StressDrawing {
    StressRecord record;
    Image ao;
    Image ground_truth = {};  ///< Where the step is compared with it.
};

/// "learnopengl sound": with its variant.
std::string nameOf(const ConfigOptions& config);

/// Keeps one renderer, so that a config's programs compile once. Tasks of one meter differ in no
/// variant and no override. The device and the sources must outlive it.
class StressRunner {
public:
    /// Ground truths are kept in `cache_folder`; empty for nowhere.
    StressRunner(Device& device, const SourceSet& sources, std::string cache_folder);
    ~StressRunner();

    /// The record with all its figures; those of what was refused are 0. Always of one size.
    StressDrawing measure(const StressTask& task, Extent size);

private:
    struct Drawn;
    struct Ready;

    /// A device, and a renderer on it whose programs are those of the config `of`.
    struct Stage {
        Device& device;
        std::unique_ptr<Renderer> renderer = nullptr;
        std::string of = {};
    };

    Result<Ready> prepare(const StressTask& task, const StressShot& shot);
    Status render(Stage& stage, const Ready& ready, HostTextures& host,
                  const std::vector<Frame>& frames, const std::string& owner);
    Status look(const Plan& plan, const std::vector<WatchedTarget>& watched, Drawn& drawn);
    static Status show(const Stage& stage, const std::string& output, Image& picture);
    Result<Drawn> draw(const StressTask& task, const StressShot& shot);
    const Drawn* ordinaryOf(const StressTask& task, Extent size);
    void compare(const StressTask& task, Extent size, const StressShot& shot, StressDrawing& done);
    void compareToTruth(const StressTask& task, const StressShot& shot, StressDrawing& done) const;

    std::unique_ptr<Device> poison_;
    std::unique_ptr<Device> floats_;  ///< The same, with every target in 32-bit floats.
    const Substitutes substitutes_;
    const std::string cache_folder_;
    Stage plain_;
    Stage wide_;
    std::string ordinary_of_;
    std::unique_ptr<Drawn> ordinary_;
};

}  // namespace crevice
