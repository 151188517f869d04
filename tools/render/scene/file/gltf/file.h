// SPDX-License-Identifier: MIT
// A glTF 2.0 file: its JSON, what tinygltf makes of it, and the numbers of its accessors.
//
// Sources: Khronos Group, "glTF 2.0 Specification" (2021); EXT_meshopt_compression and
// KHR_draco_mesh_compression in Khronos' glTF repository.
#pragma once

#include "tools/render/scene/file/gltf/tinygltf.h"
#include "tools/render/scene/file/import.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace crevice {

using nlohmann::json;

/// A file that says what cannot be; load.cpp makes CV7002 of it.
struct BrokenGltf : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The member of that name; null where there is none, or nothing has members.
const json& member(const json& object, const std::string& name);

/// Below "extensions".
const json& extensionOf(const json& object, const std::string& name);

/// The entry of a list; null where there is none.
const json& entryOf(const json& list, const json& index);
const json& entryOf(const json& list, int index);

/// The data URI with the type that tinygltf knows. Throws BrokenGltf.
std::string octets(const std::string& data_uri);

/// The finite number, or `otherwise`.
double numberOf(const json& value, double otherwise);

/// The whole number from 0 on, or -1.
int indexOf(const json& value);

class GltfFile {
public:
    /// Its JSON alone. Throws BrokenGltf. Errors: CV7002.
    static Result<GltfFile> parse(const std::string& path);

    /// Has tinygltf read it and its buffers, unless it would unfold to more than its size allows.
    /// Throws BrokenGltf. Errors: CV7002.
    Status load(const std::string& path, SceneFolder& folder);

    const json& document() const { return document_; }
    const json& list(const char* name) const { return member(document_, name); }
    const tinygltf::Model& model() const { return model_; }

    /// Values of an accessor, `components` for each element: those of integers that are normalised
    /// from -1 or 0 to 1, sparse ones in their place. Components that it does not have are 0, or 1
    /// for the fourth. Throws BrokenGltf.
    std::vector<float> numbers(int accessor, int components) const;

    /// Of an accessor of whole numbers. Throws BrokenGltf.
    std::vector<std::uint32_t> indices(int accessor) const;

    /// Elements of an accessor; 0 where there is none of that index.
    std::size_t count(int accessor) const;

    const tinygltf::Accessor& accessor(int index) const;

    /// Of a buffer view, unfolded where meshopt compressed it. Throws BrokenGltf.
    std::string_view view(int index) const;

private:
    template <class Use>
    void eachElement(int accessor, const Use& use) const;
    std::string unfoldedView(int index, const json& packed) const;

    json document_ = {};
    std::string binary_ = {};  // the chunk of that name, until it is loaded
    tinygltf::Model model_ = {};
    mutable std::map<int, std::string> unfolded_ = {};  // by buffer view
};

/// What the largest value of a component of that type counts as 1 when it is normalised.
double largestOf(int component_type);

}  // namespace crevice
