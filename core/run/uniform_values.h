// SPDX-License-Identifier: MIT
// The value table: every number that a plan's uniforms are fed from, in one block of memory.
//
// Private to core/run. A param, the camera or a draw writes its place in the block; a prepared
// uniform is an offset into it. Nothing here allocates once the table is filled.
#pragma once

#include <crevice/plan.h>

#include "core/frame/frame_math.h"

#include <cstring>

namespace crevice {

/// 32-bit words that so many elements of a value take.
std::size_t wordsOf(GlslType type, int count);

class ValueTable {
public:
    /// Has room for the frame's values, the plan's params and kernels. The plan must outlive it.
    explicit ValueTable(const Plan& plan);

    /// Where the value of a uniform begins, in words.
    std::size_t offsetOf(const PlanUniform& uniform) const;
    const void* data(std::size_t offset) const { return &words_[offset]; }

    /// By FrameValue.
    const void* frameValue(std::size_t value) const { return data(offsets_[value]); }

    /// The first component of a float param of the plan.
    float param(int index) const;
    void setParam(int index, const float* values);
    void setKernel(std::size_t generated, const std::vector<glm::vec3>& offsets);
    void setFrame(const Frame& frame, const CameraMatrices& camera);
    void setHistory(const FrameHistory& history, const CameraMatrices& camera);
    void setViewport(Extent extent);
    void setLayer(int layer) { write(first_layer, static_cast<std::int32_t>(layer)); }

    /// From view space to [0, 1] along each edge of one of the plan's boxes.
    void setBox(std::size_t box, const CameraMatrices& drawn, const CameraMatrices& camera);

    /// The values of a draw whose mesh lies at `view_from_mesh`. `normals`: whether anything reads
    /// how those turn, which takes as long as all else; if not, that value means nothing.
    void setDraw(const glm::dmat4& view_from_mesh, const Material& material,
                 const CameraMatrices& camera, bool normals);

    /// The values of a draw as one piece of so many words, from `drawOffset` on.
    std::size_t drawWords() const { return draw_words_; }
    std::size_t drawOffset() const { return offsets_[clip_from_model]; }
    void keepDraw(std::uint32_t* words) const;
    void takeDraw(const std::uint32_t* words);

private:
    void add(GlslType type, int count);

    template <class T>
    void write(std::size_t value, const T& data, int element = 0)
    {
        static_assert(sizeof(T) % sizeof(std::uint32_t) == 0, "whole words");
        const std::size_t step = sizeof(T) / sizeof(std::uint32_t);
        std::memcpy(&words_[offsets_[value] + element * step], &data, sizeof(T));
    }

    const Plan& plan_;
    glm::dmat3 ray_from_uv_ = glm::dmat3(1.0);
    std::vector<std::size_t> offsets_;  // of the frame's values, params and generated
    std::vector<std::uint32_t> words_;
    std::size_t draw_words_;
};

}  // namespace crevice
