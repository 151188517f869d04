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
};

struct MatrixScene {
    Scene scene;
    Bounds bounds;
    std::string content;  ///< A hash over it.
};

/// A config with its variant and params, whose outputs are those that its checks look at.
struct MatrixSubject {
    Description description;
    std::string content;                               ///< A hash over its document and its GLSL.
    std::vector<std::string> exported;                 ///< Its own outputs but those on request.
    std::map<std::string, OutputSource> sources = {};  ///< Of the checks' outputs.
};

/// What a choice shows.
struct MatrixShot {
    const MatrixScene* scene;
    MatrixSubject* subject;
    SceneCamera camera;
    Extent extent;
};

struct MatrixPlan {
    const Matrix& matrix;
    std::vector<std::size_t> cells = {};  ///< Into Matrix::cells: those chosen.
    Diagnostics warnings = {};
    std::map<MatrixChoice, MatrixShot> shots = {};  ///< Of them and of those they compare with.
    std::map<std::string, Result<MatrixScene>> scenes = {};      ///< What choices share.
    std::map<std::string, Result<MatrixSubject>> subjects = {};  ///< The same.
};

/// Bytes of an approved file, at most.
constexpr std::size_t kMaxApproved = 1u << 30;

/// Where a check's approved file is.
std::string approvedFile(const Matrix& matrix, const MatrixCell& cell, const MatrixCheck& check);

/// Over all that decides the cell's results, but the driver; `version` of what judges.
std::string keyOf(const MatrixPlan& plan, const MatrixCell& cell, const std::string& version);

/// The shard-th (from 1) of so many parts of a list.
std::vector<std::size_t> shardOf(const std::vector<std::size_t>& list, std::size_t shard,
                                 std::size_t shards);

/// Loads configs and scenes of the cells that are chosen and of those that they are compared with.
/// Warns of approved files that no cell has.
///
/// Errors, as many as there are: those of loading, each with the place in the matrix file; CV2209
/// for an output that a config does not have; CV4004 for `truth` of a config without a radius;
/// CV8001 where no cell is chosen.
Result<MatrixPlan> planMatrix(const Matrix& matrix, const MatrixOptions& options,
                              const SourceSet& sources);

}  // namespace crevice
