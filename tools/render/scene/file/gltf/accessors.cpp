// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/gltf/file.h"

#include <meshoptimizer.h>

#include <cstring>

namespace crevice {

namespace {

[[noreturn]] void broken(const std::string& what, int index, const std::string& why)
{
    throw BrokenGltf(what + " " + std::to_string(index) + " " + why);
}

template <class Read>
double asNumber(const unsigned char* at)
{
    Read value;
    std::memcpy(&value, at, sizeof(value));
    return static_cast<double>(value);
}

double componentAt(const unsigned char* at, int type)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return asNumber<std::int8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return asNumber<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return asNumber<std::int16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return asNumber<std::uint16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return asNumber<std::uint32_t>(at);
    default: return asNumber<float>(at);
    }
}

std::size_t bytesOf(int component_type)
{
    const int bytes = tinygltf::GetComponentSizeInBytes(std::uint32_t(component_type));
    return bytes > 0 && component_type != TINYGLTF_COMPONENT_TYPE_DOUBLE ? std::size_t(bytes) : 0;
}

// Rows of elements, `stride` apart.
struct Rows {
    const unsigned char* at;
    std::size_t stride;
};

// `count` elements of `size` bytes each, from `offset` on.
Rows rowsIn(const GltfFile& file, int view, std::size_t offset, std::size_t count, std::size_t size)
{
    const std::string_view bytes = file.view(view);
    const std::size_t given = file.model().bufferViews[std::size_t(view)].byteStride;
    const std::size_t stride = given > 0 ? given : size;
    const bool fits = count == 0 || (offset <= bytes.size() && size <= bytes.size() - offset &&
                                     count - 1 <= (bytes.size() - offset - size) / stride);
    if (!fits) broken("bufferView", view, "is shorter than what is read from it");
    return {reinterpret_cast<const unsigned char*>(bytes.data()) + offset, stride};
}

// Columns of matrices begin at multiples of four bytes.
std::size_t columnBytes(int type, std::size_t component)
{
    const int rows = type == TINYGLTF_TYPE_MAT2 ? 2 : type == TINYGLTF_TYPE_MAT3 ? 3 : 4;
    return (std::size_t(rows) * component + 3) / 4 * 4;
}

}  // namespace

double largestOf(int component_type)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return 127;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 255;
    case TINYGLTF_COMPONENT_TYPE_SHORT: return 32767;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 65535;
    default: return 1;
    }
}

const tinygltf::Accessor& GltfFile::accessor(int index) const
{
    if (index < 0 || std::size_t(index) >= model_.accessors.size())
        broken("accessor", index, "is used, and the file has none of that number");
    return model_.accessors[std::size_t(index)];
}

std::size_t GltfFile::count(int index) const { return index < 0 ? 0 : accessor(index).count; }

std::string_view GltfFile::view(int index) const
{
    if (index < 0 || std::size_t(index) >= model_.bufferViews.size())
        broken("bufferView", index, "is used, and the file has none of that number");
    const json& packed =
        extensionOf(entryOf(list("bufferViews"), index), "EXT_meshopt_compression");
    if (!packed.is_null()) {
        const auto [known, added] = unfolded_.try_emplace(index);
        if (added) known->second = unfoldedView(index, packed);
        return known->second;
    }
    const tinygltf::BufferView& view = model_.bufferViews[std::size_t(index)];
    if (view.buffer < 0 || std::size_t(view.buffer) >= model_.buffers.size())
        broken("bufferView", index, "is in no buffer");
    const std::vector<unsigned char>& all = model_.buffers[std::size_t(view.buffer)].data;
    if (view.byteOffset > all.size() || view.byteLength > all.size() - view.byteOffset)
        broken("bufferView", index, "reaches past the end of its buffer");
    return {reinterpret_cast<const char*>(all.data()) + view.byteOffset, view.byteLength};
}

std::string GltfFile::unfoldedView(int index, const json& packed) const
{
    const int buffer = indexOf(member(packed, "buffer"));
    const double offset = numberOf(member(packed, "byteOffset"), 0);
    const double length = numberOf(member(packed, "byteLength"), 0);
    const double stride = numberOf(member(packed, "byteStride"), 0);
    const double count = numberOf(member(packed, "count"), 0);
    if (buffer < 0 || std::size_t(buffer) >= model_.buffers.size() || offset < 0 || length < 0 ||
        offset + length > static_cast<double>(model_.buffers[std::size_t(buffer)].data.size()))
        broken("bufferView", index, "is compressed in bytes that are not there");
    // What the decoder asserts. A triangle takes a byte of its codec at least, a vertex's byte in
    // 16 a quarter.
    const std::string mode = member(packed, "mode").is_string() ? packed["mode"] : "";
    const std::string filter = member(packed, "filter").is_string() ? packed["filter"] : "NONE";
    const bool attributes = mode == "ATTRIBUTES", triangles = mode == "TRIANGLES";
    const bool strides = attributes ? stride > 0 && stride <= 256 && std::fmod(stride, 4) == 0
                                    : stride == 2 || stride == 4;
    const bool counts =
        count >= 0 && count <= 3 * 1024 * (length + 1) && (!triangles || std::fmod(count, 3) == 0);
    if (!strides || !counts || !(attributes || triangles || mode == "INDICES"))
        broken("bufferView", index, "is compressed in no way that EXT_meshopt_compression knows");

    const auto rows = static_cast<std::size_t>(count), bytes = static_cast<std::size_t>(stride);
    const unsigned char* const from =
        model_.buffers[std::size_t(buffer)].data.data() + static_cast<std::size_t>(offset);
    const auto size = static_cast<std::size_t>(length);
    std::string unfolded(rows * bytes, '\0');
    char* const to = unfolded.data();
    const int failed = attributes  ? meshopt_decodeVertexBuffer(to, rows, bytes, from, size)
                       : triangles ? meshopt_decodeIndexBuffer(to, rows, bytes, from, size)
                                   : meshopt_decodeIndexSequence(to, rows, bytes, from, size);
    if (failed != 0) broken("bufferView", index, "does not unfold: its bytes are damaged");
    if (filter == "OCTAHEDRAL" && (bytes == 4 || bytes == 8))
        meshopt_decodeFilterOct(to, rows, bytes);
    else if (filter == "QUATERNION" && bytes == 8)
        meshopt_decodeFilterQuat(to, rows, bytes);
    else if (filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(to, rows, bytes);
    else if (filter != "NONE")
        broken("bufferView", index, "has the unknown filter '" + filter + "'");
    return unfolded;
}

// Calls use(element, component, value) with every value as it is stored.
template <class Use>
void GltfFile::eachElement(int index, const Use& use) const
{
    const tinygltf::Accessor& from = accessor(index);
    const std::size_t size = bytesOf(from.componentType);
    const int components = tinygltf::GetNumComponentsInType(std::uint32_t(from.type));
    if (size == 0 || components <= 0) broken("accessor", index, "has an unknown type");
    const bool matrix = from.type >= TINYGLTF_TYPE_MAT2 && from.type <= TINYGLTF_TYPE_MAT4;
    const std::size_t column =
        matrix ? columnBytes(from.type, size) : size * std::size_t(components);
    const int rows = matrix ? int(std::lround(std::sqrt(components))) : components;
    const std::size_t element = matrix ? column * std::size_t(rows) : column;
    const auto take = [&](std::size_t to, const unsigned char* at) {
        for (int k = 0; k < components; ++k)
            use(to, k,
                componentAt(at + column * std::size_t(k / rows) + size * std::size_t(k % rows),
                            from.componentType));
    };
    if (from.bufferView >= 0) {
        const Rows all = rowsIn(*this, from.bufferView, from.byteOffset, from.count, element);
        for (std::size_t k = 0; k < from.count; ++k) take(k, all.at + k * all.stride);
    }
    if (!from.sparse.isSparse) return;
    const auto& [count, sparse, at, values] = from.sparse;
    const std::size_t changed = count > 0 ? std::size_t(count) : 0;
    const std::size_t index_size = bytesOf(at.componentType);
    if (index_size == 0) broken("accessor", index, "has sparse indices of an unknown type");
    const Rows places =
        rowsIn(*this, at.bufferView, std::size_t(std::max(at.byteOffset, 0)), changed, index_size);
    const Rows given = rowsIn(*this, values.bufferView, std::size_t(std::max(values.byteOffset, 0)),
                              changed, element);
    for (std::size_t k = 0; k < changed; ++k) {
        const double place = componentAt(places.at + k * places.stride, at.componentType);
        if (!(place >= 0 && place < static_cast<double>(from.count)))
            broken("accessor", index, "has a sparse index outside of it");
        take(static_cast<std::size_t>(place), given.at + k * given.stride);
    }
}

std::vector<float> GltfFile::numbers(int index, int components) const
{
    const tinygltf::Accessor& from = accessor(index);
    std::vector<float> all(from.count * std::size_t(components), 0.0f);
    const int given = tinygltf::GetNumComponentsInType(std::uint32_t(from.type));
    if (components == 4 && given == 3)
        for (std::size_t k = 3; k < all.size(); k += 4) all[k] = 1.0f;
    const double scale = from.normalized ? 1 / largestOf(from.componentType) : 1;
    eachElement(index, [&](std::size_t element, int component, double value) {
        if (component < components)
            all[element * std::size_t(components) + std::size_t(component)] =
                static_cast<float>(from.normalized ? std::max(value * scale, -1.0) : value);
    });
    return all;
}

std::vector<std::uint32_t> GltfFile::indices(int index) const
{
    std::vector<std::uint32_t> all(accessor(index).count, 0u);
    eachElement(index, [&](std::size_t element, int component, double value) {
        if (component == 0 && value >= 0 && value < 4294967296.0)
            all[element] = static_cast<std::uint32_t>(value);
    });
    return all;
}

}  // namespace crevice
