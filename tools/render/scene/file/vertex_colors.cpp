// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/vertex_colors.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <numeric>

namespace crevice {

Image paintedCorners(const std::vector<float>& colors, double most_texels, MeshDesc& mesh)
{
    const std::size_t triangles = mesh.indices.size() / 3;
    const int blocks = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(triangles))));
    const int side = 2 * blocks;
    if (triangles == 0 || static_cast<double>(side) * side > most_texels) return {};
    Image image({side, side}, 4, 1.0f);
    std::vector<Vertex> corners;
    corners.reserve(mesh.indices.size());
    for (std::size_t k = 0; k < triangles; ++k) {
        const int x = 2 * (static_cast<int>(k) % blocks), y = 2 * (static_cast<int>(k) / blocks);
        glm::vec4 texels[4];
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t index = mesh.indices[3 * k + static_cast<std::size_t>(corner)];
            for (int channel = 0; channel < 4; ++channel) {
                const float value = colors[4 * std::size_t{index} + std::size_t(channel)];
                texels[corner][channel] = std::isfinite(value) ? value : 1.0f;
            }
            Vertex& vertex = corners.emplace_back(mesh.vertices[index]);
            vertex.uv[0] = (static_cast<float>(x + corner % 2) + 0.5f) / static_cast<float>(side);
            vertex.uv[1] = (static_cast<float>(y + corner / 2) + 0.5f) / static_cast<float>(side);
        }
        texels[3] = texels[1] + texels[2] - texels[0];
        for (int texel = 0; texel < 4; ++texel)
            for (int channel = 0; channel < 4; ++channel)
                image.at(x + texel % 2, y + texel / 2, channel) = texels[texel][channel];
    }
    mesh.vertices = std::move(corners);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    return image;
}

}  // namespace crevice
