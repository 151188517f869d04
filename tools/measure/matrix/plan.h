// SPDX-License-Identifier: MIT
// The cells of a matrix with all that they are drawn from, found before anything is drawn.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/measure/matrix/matrix.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/scene.h"

namespace crevice {

struct MatrixOptions {
    std::string checkout = {};  ///< As ConfigOptions has it.
    std::vector<std::string> roots = {};
    std::string filter = {};  ///< What the names of cells contain.
    std::size_t shard = 1, shards = 1;
    std::string version = {};  ///< Of crevice; a part of each key.
};

struct MatrixScene {
    Scene scene;
    Bounds bounds;
    std::string content;  ///< A hash over it.
};

struct MatrixView {
    SceneCamera camera;
    Extent extent;
};

/// A config with its variant and overrides, whose outputs are those that its checks look at.
struct MatrixSubject {
    Description description;
    std::string content;  ///< A hash over its document and its GLSL.
    /// Of the checks' outputs, how each is met.
    std::map<std::string, OutputSource> sources;
    std::vector<std::string> exported = {};  ///< Its own outputs.
    bool has_radius = false;
};

/// What choices share.
struct MatrixPlan {
    const Matrix& matrix;
    std::map<std::string, MatrixScene> scenes;       ///< By text.
    std::map<MatrixChoice, MatrixSubject> subjects;  ///< By subjectOf.
    std::map<MatrixChoice, MatrixView> views;        ///< By viewOf.
    std::vector<std::size_t> cells = {};             ///< Into Matrix::cells: those chosen.
    Diagnostics warnings = {};

    const MatrixScene& scene(const MatrixChoice& choice) const
    {
        return scenes.at(matrix.value(choice, kSceneAxis).text);
    }
    const MatrixSubject& subject(const MatrixChoice& choice) const;
    const MatrixView& view(const MatrixChoice& choice) const;
};

/// Bytes of an approved file, at most.
constexpr std::size_t kMaxApproved = 1u << 30;

/// Where a check's approved file is.
std::string approvedFile(const Matrix& matrix, const MatrixCell& cell, const MatrixCheck& check);

/// Over all that decides the cell's results, but the driver.
std::string keyOf(const MatrixPlan& plan, const MatrixCell& cell, const std::string& version);

/// Loads configs and scenes of the cells that are chosen and of those that they are compared with.
///
/// Errors, as many as there are: those of loading, each with the place in the matrix file; CV2209
/// for an output that a config does not have; CV4004 for `truth` of a config without a radius;
/// CV8001 where no cell is chosen.
Result<MatrixPlan> planMatrix(const Matrix& matrix, const MatrixOptions& options,
                              const SourceSet& sources);

/// A warning that names approved files of the folder that no cell of the matrix has.
Diagnostics unusedApproved(const Matrix& matrix);

}  // namespace crevice
