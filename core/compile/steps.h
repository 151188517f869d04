// SPDX-License-Identifier: MIT
// The steps of the compiler, private to core/compile. They fill its state in this order:
//
//   elided        which passes run, once borders fit (target_sizes)
//   formats       formats, which shaders allow for; at the end whether they fit and are fine enough
//   shaders       defines, stages, outputs; with uniforms for what they declare
//   graph         writers and order
//   dead_passes   what is needed, and what stands in for what is not
//   target_sizes  sizes and samples
//   passes        the plan itself; with texture_aliasing, and elided for what is left out
#pragma once

#include "core/compile/state.h"

namespace crevice::compiler {

// formats.cpp
void chooseFormats(State& state);
void checkFormats(State& state);
/// The warning CV6015.
void lintPrecision(State& state);

// shaders.cpp
/// The macro by which a shader allows for the steps of what a texture stores.
std::string stepDefine(const std::string& texture);
void readShaders(State& state);

// uniforms.cpp
/// Finds what feeds the uniform, and adds that to the pass.
void bindUniform(State& state, Pass& pass, const GlslUniform& uniform);
void checkLimits(State& state, const Pass& pass, const Shader& shader);
/// Offsets or pixels, from the param where one is named.
int generatedCount(const Description& description, const GeneratedDesc& generated);

// graph.cpp
void findWriters(State& state);
void orderPasses(State& state);

// dead_passes.cpp
void chooseLive(State& state);
/// The warning CV2212.
void lintDeadPasses(State& state);

/// What a reader gets, with inactive passes and those that a no-op replaces looked through;
/// nothing when no active pass is behind it.
std::optional<Source> resolve(const State& state, const Source& source);
std::optional<Source> resolveTarget(const State& state, int target);

// target_sizes.cpp
/// The description with params lowered whose borders make targets larger than the device's
/// textures, and what that leaves out; nothing where all fit. The first step: all others see the
/// result.
std::optional<Description> fitBorders(const State& state, std::vector<Elided>& elided);
/// How large the target is, in pixels.
Extent sizeOf(const State& state, int target);
/// How many views a target shows that has a border or follows one, in the direction in which that
/// is more; 0 without a border.
float viewsOf(const State& state, int target);
void chooseExtents(State& state);
/// Samples of a pixel that the config asks for.
int askedSamples(const State& state, int target);
void chooseSamples(State& state);

// texture_aliasing.cpp
/// Fills the plan's texture list and each plan target's slot. Requires views, passes and lifetimes.
void shareTextures(const State& state, Plan& plan);

// elided.cpp
void decideConditions(State& state);
std::vector<Elided> elided(const State& state);

// passes.cpp
Plan buildPlan(const State& state);

}  // namespace crevice::compiler
