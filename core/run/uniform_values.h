// SPDX-License-Identifier: MIT
// The value table: every number that a uniform may be fed from, by name, in one block of memory.
//
// Private to the renderer. A param, the camera or a draw writes its place in the block; a prepared
// uniform is an offset into it. Nothing here allocates once the table is filled.
#pragma once

#include "core/config/description.h"
#include "core/frame/frame_math.h"

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

/// A name's place in the table.
struct Value {
    std::string name;
    GlslType type = GlslType::float_;
    int count = 1;
    bool per_draw = false;   ///< Changes with each draw of a pass.
    std::size_t offset = 0;  ///< In 32-bit words.
};

/// 32-bit words that so many elements of a value take.
std::size_t wordsOf(GlslType type, int count);

class ValueTable {
public:
    /// Holds the values of core/frame/frame.h and the description's params.
    explicit ValueTable(const std::vector<ParamDesc>& params);

    /// Computes a kernel and adds it. Errors: those of makeKernel, at the kernel's place.
    Status addKernel(const GeneratedDesc& kernel);

    /// The value of that name, or null.
    const Value* find(std::string_view name) const;

    /// The first of a value's words, by its offset.
    const void* data(std::size_t offset) const { return &words_[offset]; }

    void setParam(const ParamDesc& param);
    void setFrame(const Frame& frame, const CameraMatrices& camera);
    void setHistory(const FrameHistory& history, const CameraMatrices& camera);
    void setViewport(Extent extent);
    void setDraw(const DrawItem& item, const Material& material, const CameraMatrices& camera);

private:
    std::size_t add(std::string name, GlslType type, int count, bool per_draw);

    template <class T>
    void write(std::size_t value, const T& data, int element = 0)
    {
        static_assert(sizeof(T) % sizeof(std::uint32_t) == 0, "whole words");
        const std::size_t step = sizeof(T) / sizeof(std::uint32_t);
        std::memcpy(&words_[values_[value].offset + element * step], &data, sizeof(T));
    }

    std::vector<Value> values_;  // those of the frame come first, in the order of FrameValue
    std::vector<std::uint32_t> words_;
};

}  // namespace crevice
