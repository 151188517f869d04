// SPDX-License-Identifier: MIT
// A view in two sizes, and what configs do in them: their errors over some pixels, with margins,
// and their costs. What takes long comes in steps, between which a page is drawn.
#pragma once

#include "tools/measure/bench/times.h"
#include "tools/measure/motion/measure.h"
#include "tools/measure/reference/sparse_truth.h"
#include "tools/render/host_textures.h"
#include "tools/render/scene_upload.h"

namespace crevice {

/// What a config did in one picture.
struct Look {
    SparseError error;
    double with_flicker = 0;          ///< The rmse, and flickerOf() where that is measured.
    std::vector<double> costs;        ///< As occlusionCost has them, of each turn.
    std::vector<double> ratios;       ///< Of these over that of learnopengl; none without it.
    const TurnTaker* unit = nullptr;  ///< Of learnopengl.

    /// Of each turn: the ratios times the median of all turns of learnopengl, so that they compare
    /// with those of another moment; without it the costs.
    std::vector<double> milliseconds() const;

    explicit operator bool() const { return !costs.empty(); }
};

/// Of the full picture, to begin with: margins of 2 to 4 %.
constexpr std::size_t kFullPixels = 16000;

/// A config with what is set in it, and what is known of it.
struct Entrant {
    std::string config;
    std::vector<std::string> overrides;
    std::string setting = {};  ///< What makes it a neighbour of another; else empty ...
    std::string of = {};       ///< ... and that one's label.

    Description description = {};  ///< With lengths in scene units, from ViewMeter::load.
    std::string passes = {};       ///< The plan of its occlusion at full size ...
    std::string programs =
        {};  ///< ... and its programs' keys: who has both the same draws the same.
    Drawn drawn = {};
    Look small = {}, full = {};
    MotionFigures motion = {};
    TimingMethod clock = TimingMethod::wall_clock;
    double texture_bytes = 0;  ///< At full size.
    bool has_neighbours = false;

    std::string label() const;  ///< As sampleLabel has it.
};

/// Milliseconds of a whole frame of a config, of which a host may draw some itself.
struct FrameShares {
    double occlusion = 0;     ///< As occlusionCost has it.
    double own_geometry = 0;  ///< Drawn for it alone: back faces, layers.
    double geometry = 0;      ///< Drawn for it and for others.
    double lighting = 0;      ///< All other passes.
};

struct ViewMeterOptions {
    std::string scene;                    ///< Its name, as --scene has it.
    std::vector<std::string> roots = {};  ///< As LoadRequest has them.
    bool motion = false;                  ///< Flicker, in the small picture.
    std::string version = {};             ///< Of crevice.
    std::function<bool()> interrupted = [] { return false; };
};

/// The device, the view and the sources must outlive it.
class ViewMeter {
public:
    ViewMeter(Device& device, const BenchView& view, const SourceSet& sources,
              ViewMeterOptions options)
        : device_(device),
          seen_(view),
          sources_(sources),
          options_(std::move(options))
    {
    }

    /// Uploads the scene and opens the small picture. The radius is that of `first`. Errors: those
    /// of `load`, of the device and of SparseTruth.
    Status begin(Entrant& first);

    /// So that configs can be drawn in it once its truth is known. Errors: those of SparseTruth.
    Status openFull();
    Extent smallExtent() const { return small_.view.extent; }

    /// Gives it a description with everyone's radius, and its plan. Errors: those of
    /// loadDescription, resolveLengths and `compile`; CV2102 for a config without the param
    /// `radius` or the output `ao`.
    Status load(Entrant& entrant);

    /// Draws it in a picture, and leaves turns to be taken there: with `rough` one, else three.
    /// It must stay in its place until `finish`. Errors: those of Drawn::prepare, of drawing and
    /// of sparseError.
    Status lookSmall(Entrant& entrant, bool rough);
    Status lookFull(Entrant& entrant) { return look(entrant, full_, false); }

    /// What a look left to be taken; null after `finish`.
    Turns* turns() const { return looking_ ? &looking_->turns : nullptr; }

    /// Adds the turns that were taken to the entrant's costs.
    void finish();

    /// Forgets a look whose turns failed.
    void drop() { looking_.reset(); }

    /// Medians of whole frames at full size. Errors: those of Drawn::prepare, timeFrame and
    /// ownGeometry.
    Result<FrameShares> sharesOf(Entrant& entrant);

    /// Traces a part of the full picture's truth; false where `pixels` of it, or all, are known.
    Result<bool> grow(std::size_t pixels);

    /// What is known of it at full size. Requires that it was drawn there.
    BenchSample sampleOf(const Entrant& entrant) const;

private:
    struct Picture {
        BenchView view;
        Frame frame;
        std::optional<SparseTruth> truth;
        Yardstick unit;
    };

    /// A look whose turns are not taken yet.
    struct Looking {
        Entrant& entrant;
        Picture& picture;
        TurnTaker taker;
        Turns turns;

        Looking(Entrant& looked_at, Picture& in, int count)
            : entrant(looked_at),
              picture(in),
              taker(*looked_at.drawn.renderer, looked_at.drawn.frame),
              turns(taker, in.unit.turns(), count, count)
        {
        }
    };

    Status open(Picture& picture, Extent extent);
    Look& lookOf(Entrant& entrant, const Picture& picture) const;
    Status beginMotion();
    Result<double> medianDepth();
    Result<Description> describe(const Entrant& entrant);
    Status look(Entrant& entrant, Picture& picture, bool rough);
    Status measureFlicker(Entrant& entrant);

    Device& device_;
    const BenchView& seen_;
    const SourceSet& sources_;
    const ViewMeterOptions options_;
    std::optional<UploadedScene> scene_;
    std::unique_ptr<RayScene> rays_;
    std::optional<Result<double>> distance_;  // the median one
    double radius_ = 0;
    Picture small_, full_;
    std::unique_ptr<Looking> looking_;
    std::optional<MotionView> motion_view_;
    MotionTruth motion_;
};

}  // namespace crevice
