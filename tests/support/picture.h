// SPDX-License-Identifier: MIT
// A scene on the test's GL context, what configs draw of it, and what tests ask of the pictures.
#pragma once

#include <crevice/compile.h>
#include <crevice/renderer.h>

#include "tests/support/gl_fixture.h"
#include "tools/render/scene_upload.h"

namespace crevice {

/// Draws one description after the other. Programs of the same text compile once, since that is
/// what most pictures take on software GL.
struct DrawRig : GlFixture {
    using GlFixture::GlFixture;

    /// A renderer of its own, which draws the outputs, or all where none is named.
    std::unique_ptr<Renderer> renderer(const Description& description, const Frame& frame,
                                       std::vector<std::string> outputs = {}) const;

    /// The rig's renderer, or a second one beside it, with this description in place of its last.
    Renderer& reloaded(const Description& description, const Frame& frame,
                       const CompileOptions& options, int index = 0);

    /// The output after that many frames of the same, of 0 after as many as a history takes to
    /// settle. In full where the plan knows it to be one number.
    Image draw(const Description& description, const Frame& frame, const std::string& output = "ao",
               int frames = 1);

    Extent extent = {128, 72};

private:
    std::unique_ptr<Renderer> kept_[2];
};

struct SceneRig : DrawRig {
    explicit SceneRig(Scene shown, Extent size = {128, 72}, const GlDeviceOptions& options = {});
    explicit SceneRig(const std::string& built_in, Extent size = {128, 72});

    /// Another scene in its place, under the same programs.
    void show(Scene shown);
    void show(const std::string& built_in) { show(need(loadScene(built_in))); }

    /// What the scene's own camera sees, or one as `--camera` has it.
    Frame frame(const std::string& camera = "") const;

    Scene scene;
    UploadedScene uploaded;
};

/// The description with a target of it as its one output, "shown".
Description showing(Description description, const std::string& target);

/// The mean over all pixels of the first channel.
double mean(const Image& image);

/// That of some rows, from the first up to the last.
double meanOfRows(const Image& image, int first, int last);

float least(const Image& image);

/// The share of pixels that are below `limit`.
double shareBelow(const Image& image, float limit);

/// The mean absolute difference of two pictures of one size.
double meanChange(const Image& a, const Image& b);

/// True when every value is finite and in [0, 1].
bool allVisibility(const Image& image);

}  // namespace crevice
