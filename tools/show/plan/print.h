// SPDX-License-Identifier: MIT
// Plans as text, JSON and Graphviz, and where a value of a merged document came from: what
// `crevice explain` prints.
#pragma once

#include <crevice/compile.h>
#include <crevice/document.h>
#include <crevice/plan.h>

#include <nlohmann/json_fwd.hpp>

namespace crevice {

/// Text for people, stable enough to compare in tests.
std::string toText(const Plan& plan);
std::string toJson(const Plan& plan);

/// JSON for people too: an object or list takes one line unless objects are in it.
std::string jsonLines(const nlohmann::ordered_json& json, const std::string& indent = "");

/// A drawing for Graphviz: passes are boxes, textures are ellipses, edges follow the data.
std::string toDot(const Plan& plan);

/// The words in which plans are printed.
const char* nameOf(LoadOp load);
const char* nameOf(StoreOp store);
const char* nameOf(InputKind kind);
const char* nameOf(UniformSource source);

/// What a sampler reads: a target's, generated value's or import's name, "material" or a number.
std::string sourceName(const Plan& plan, const PlanInput& input);

/// "256x144".
std::string sizeText(const Extent& extent);

/// "288.0 KiB".
std::string bytesText(double bytes);

/// "1 pass", "2 passes".
std::string counted(std::size_t count, const std::string& what);

/// ", 4 samples"; nothing for one.
std::string samplesText(int samples);

/// The texture behind a target of the plan.
const PlanTexture& textureOf(const Plan& plan, int target);

/// Of all views in one frame, with one texel of each input a pixel.
struct MovedBytes {
    double read = 0;
    double loaded = 0;   ///< Of `read`: what tiled GPUs load before they draw, the pass's mask.
    double written = 0;  ///< What they store when a tile is drawn.
};

MovedBytes movedBytes(const Plan& plan, const PlanPass& pass);
MovedBytes movedBytes(const Plan& plan);

/// GL textures that the plan has, with the second copies that history needs.
std::size_t textureCount(const Plan& plan);

/// What the plan says, the textures that targets share, and what each frame may leave out.
std::vector<Elided> allElided(const Plan& plan);

/// The config with its param `intensity` at 0; as it is where it has none.
Description withoutOcclusion(Description description);

/// For each pass of the plan: whether it draws geometry for the occlusion alone, such as back faces
/// or, with forward lighting, depth ahead of the light. Those are its draw passes that a plan for
/// all outputs of the config lacks without occlusion. Extent and `disable` come from `options`.
///
/// Errors: those of `compile`.
Result<std::vector<bool>> ownGeometry(const Plan& plan, const Description& description,
                                      const SceneTraits& traits, const DeviceCaps& caps,
                                      CompileOptions options);

/// A value with the RFC 6901 pointer that leads to it.
struct FoundValue {
    std::string pointer;
    const Node* node = nullptr;  ///< Into the document that was searched.
    /// Where a level sets it by its bare name, the default that counts for nothing, if that is
    /// another value; else empty.
    std::vector<FoundValue> overruled = {};
};

/// Finds "/passes/ssao/inputs/depth", "passes.ssao.inputs.depth", or a param's or feature's default
/// by its bare name.
/// Errors: CV2102 that names the last part found and what it holds, or what else has the name.
Result<FoundValue> findValue(const Node& document, const std::string& path);

/// "params" and "features", each with its value, the default that its module gave it, what it may
/// be, and who set it. Errors: those of loadConfig and decode.
Result<nlohmann::ordered_json> settingsJson(const SourceSet& sources, const LoadRequest& request);

/// The value, and each place that set it, the newest first, then the same of what it overrules; of
/// an object, those of all values in it.
std::string explainText(const FoundValue& value);

/// The same as {"pointer", "value", "places": [{"file", "line", "column", "text"}]}, where an
/// object has "members" and what overrules a default "overruled", lists of these.
std::string explainJson(const FoundValue& value);

}  // namespace crevice
