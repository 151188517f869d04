// SPDX-License-Identifier: MIT
// glTF files of a test's own making.
#pragma once

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/render/scene/scene.h"

#include <nlohmann/json.hpp>

namespace crevice {

/// A square from (0, 0, 0) to (1, 1, 0) as mesh 0 of one node; `json` may be changed at will.
struct GltfTestFile {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}},
                           {"nodes", {{{"mesh", 0}}}},
                           {"scenes", {{{"nodes", {0}}}}},
                           {"scene", 0}};
    std::string bytes = {};
    std::string uri = "my%20data.bin";  ///< Of the bytes.

    GltfTestFile()
    {
        const int positions = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
        const int indices = numbers<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 5123);
        json["meshes"] = {
            {{"primitives", {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}}}};
    }

    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

    int view(const void* data, std::size_t size)
    {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
        bytes.append(static_cast<const char*>(data), size);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }

    /// An accessor of values of a type and its number in GL.
    template <class Value>
    int numbers(const std::vector<Value>& values, const std::string& type, int component,
                bool normalized = false)
    {
        const std::size_t width = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : type[3] - '0';
        json["accessors"].push_back(
            {{"bufferView", view(values.data(), values.size() * sizeof(Value))},
             {"componentType", component},
             {"count", values.size() / width},
             {"normalized", normalized},
             {"type", type}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }

    int floats(const std::vector<float>& values, const std::string& type)
    {
        return numbers(values, type, 5126);
    }

    /// Writes a file of that name and "my data.bin", and returns the former's path.
    std::string write(const TemporaryFolder& folder, const std::string& name = "scene.gltf",
                      const std::string& before = "") const
    {
        folder.write("my data.bin", bytes);
        nlohmann::json whole = json;
        whole["buffers"][0] = {{"uri", uri}, {"byteLength", bytes.size()}};
        return folder.write(name, before + whole.dump());
    }

    /// Writes scene.glb, and returns its path.
    std::string writeBinary(const TemporaryFolder& folder) const
    {
        nlohmann::json whole = json;
        whole["buffers"][0] = {{"byteLength", bytes.size()}};
        std::string text = whole.dump(), binary = bytes;
        text.resize((text.size() + 3) / 4 * 4, ' ');
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        const auto number = [](std::size_t value) {
            std::string octets;
            for (int k = 0; k < 4; ++k) octets += static_cast<char>(value >> 8 * k & 255);
            return octets;
        };
        return folder.write("scene.glb",
                            "glTF" + number(2) + number(28 + text.size() + binary.size()) +
                                number(text.size()) + "JSON" + text + number(binary.size()) +
                                std::string("BIN\0", 4) + binary);
    }
};

inline Result<Scene> imported(const GltfTestFile& file, const ImportOptions& options = {})
{
    const TemporaryFolder folder("gltf_file");
    return importScene(file.write(folder), options);
}

/// Without a word.
inline Scene load(const GltfTestFile& file, const ImportOptions& options = {})
{
    const Result<Scene> scene = imported(file, options);
    for (const Diagnostic& each : scene.diagnostics()) FAIL_CHECK(each.message);
    return need(scene);
}

/// Of the first mesh that is drawn.
inline const SceneMaterial& materialOf(const Scene& scene)
{
    return scene.materials[static_cast<std::size_t>(scene.instances[0].material)];
}

}  // namespace crevice
