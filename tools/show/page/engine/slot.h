// SPDX-License-Identifier: MIT
// A config that runs in the page: loaded from its texts, changed by knobs, drawn.
#pragma once

#include <crevice/renderer.h>

#include "tools/render/read_output.h"

#include <nlohmann/json_fwd.hpp>

namespace crevice::page {

/// What to load.
struct SlotRequest {
    std::string config;
    std::string variant = {};
    bool file_scene = false;
    std::vector<std::string> outputs = {};  ///< Those that the config has are kept.
    std::string look = {};                  ///< A target to be kept, too; empty for none.
    bool without_occlusion = false;
};

class Slot {
public:
    /// Loads a config and plans it for the frame. A renderer that ran the same config before
    /// compiles what changed alone. Errors: those of loadConfig, decode and Renderer::create; what
    /// ran before stays.
    Status load(Device& device, const SourceSet& sources, const SlotRequest& request, Extent extent,
                const Frame& frame);

    bool loaded() const { return renderer_ != nullptr; }

    /// Errors: those of Renderer::setParam; CV4004 for a name that no param has.
    Status setParam(const std::string& name, const std::vector<float>& values);
    /// Errors: those of Renderer::setFeature.
    Status setFeature(const std::string& name, const std::string& word);

    /// Where the pixels of an output, view or target come from. Errors: CV2209 for one that is not
    /// kept.
    Result<OutputSource> sourceOf(const std::string& show) const;

    /// Params, features, outputs, targets, views and files, for a user interface.
    nlohmann::json state() const;

    /// A config that extends the shipped one by the smallest patch that makes `sources`' of it; the
    /// text itself of a config that is not shipped. Errors: those of loadConfig and decode.
    Result<std::string> patch(const SourceSet& sources) const;

    Renderer& renderer() const { return *renderer_; }

private:
    Status start(Device& device, Description description, const CompileOptions& options,
                 const Frame& frame);
    Status putBack();

    SlotRequest request_;
    std::unique_ptr<Renderer> renderer_;
    std::map<std::string, OutputSource> shown_;  // by what was asked for
    std::vector<std::string> files_;
    std::vector<std::string> variants_;
    std::vector<std::string> changed_params_;  // since the text was loaded
    std::vector<std::string> changed_features_;
    Description text_;     // as the text has it
    Description shipped_;  // the shipped config's params and features; empty for one's own
};

}  // namespace crevice::page
