// SPDX-License-Identifier: MIT
// The configs of single authors against what those authors compute, ported to the CPU from their
// texts: over the same positions, normals and random numbers, with a box over both pictures.
#include "core/sampling/generators.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <glm/glm.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace crevice {
namespace {

using glm::vec2;
using glm::vec3;
using glm::vec4;

constexpr Extent kSize = {160, 90};

/// Most rmse of a literal config. Half-float or 8-bit targets leave 0.002; depth of 24 bits and
/// normals of 10 leave up to 0.006, where a method has no bias that hides their steps.
constexpr double kLimit = 0.005, kLimitFromDepth = 0.008;

/// What an author's shader reads, and what the config made of it.
struct Drawn {
    Image position, normal, ao;
    glm::mat4 clip_from_view;

    vec3 positionAt(int x, int y) const
    {
        return {position.at(x, y, 0), position.at(x, y, 1), position.at(x, y, 2)};
    }
    bool surfaceAt(int x, int y) const { return position.at(x, y, 3) > 0.5f; }
    vec3 normalAt(int x, int y) const
    {
        const vec3 stored(normal.at(x, y, 0), normal.at(x, y, 1), normal.at(x, y, 2));
        return glm::normalize(stored * 2.0f - 1.0f);
    }
    /// The position that a texture of the projected sample gives: nearest, clamped or repeated.
    vec3 seenBehind(const vec3& sample, bool repeat) const
    {
        const vec4 clip = clip_from_view * vec4(sample, 1);
        vec2 at = vec2(clip) / clip.w * 0.5f + 0.5f;
        at = repeat ? glm::fract(at) : glm::clamp(at, 0.0f, 1.0f);
        const int x = std::min(int(at.x * kSize.width), kSize.width - 1);
        const int y = std::min(int(at.y * kSize.height), kSize.height - 1);
        return positionAt(x, y);
    }
};

/// The visibility of a pixel.
using Shader = std::function<float(const Drawn&, int x, int y)>;

struct Author {
    const char* config;
    bool from_depth;  ///< It rebuilds positions; those of the port are of 32-bit floats.
    Shader visibility;

    double limit() const { return from_depth ? kLimitFromDepth : kLimit; }
};

float smooth(float x)
{
    x = glm::clamp(x, 0.0f, 1.0f);
    return x * x * (3 - 2 * x);
}

/// A uniform number in (-1, 1).
float signedOf(Stream& stream) { return float(2.0 * stream.number() - 1.0 + 0x1p-24); }

/// Normalised (2u-1, 2u-1, u), times u, times lerp(0.1, 1, t) or lerp(0.1, 1, t^2).
std::vector<vec3> hemisphere(int count, bool squared)
{
    Stream stream{1};
    std::vector<vec3> kernel;
    for (int i = 0; i < count; ++i) {
        const float x = signedOf(stream), y = signedOf(stream), z = std::fabs(signedOf(stream));
        const float u = float(stream.number()), t = float(i) / float(count);
        kernel.push_back(glm::normalize(vec3(x, y, z)) * u *
                         glm::mix(0.1f, 1.0f, squared ? t * t : t));
    }
    return kernel;
}

/// One of 4x4 vectors (2u-1, 2u-1, 0), by the pixel.
vec3 noiseAt(int x, int y)
{
    Stream stream{2};
    vec3 vector(0);
    for (int i = 0; i <= (y % 4) * 4 + x % 4; ++i) {
        vector.x = signedOf(stream);
        vector.y = signedOf(stream);
    }
    return vector;
}

vec3 tangentOf(const vec3& n, const vec3& r) { return glm::normalize(r - n * glm::dot(n, r)); }

float ogldev(const Drawn& drawn, int x, int y)
{
    constexpr int kCount = 128;
    constexpr float kCut = 1.5f;
    static const std::vector<vec3> kernel = [] {
        Stream stream{1};
        std::vector<vec3> all;
        for (int i = 0; i < kCount; ++i) {
            const float a = signedOf(stream), b = signedOf(stream), c = signedOf(stream);
            const float t = float(i) / kCount;
            all.push_back(vec3(a, b, c) * (0.1f + 0.9f * t * t));
        }
        return all;
    }();
    const vec3 p = drawn.positionAt(x, y);
    float sum = 0;
    for (const vec3& k : kernel) {
        const vec3 s = p + k;
        const float seen = drawn.seenBehind(s, false).z;
        if (std::fabs(p.z - seen) < kCut) sum += seen >= s.z ? 1.0f : 0.0f;
    }
    const float open = 1 - sum / kCount;
    return open * open;
}

float learnopengl(const Drawn& drawn, int x, int y)
{
    static const std::vector<vec3> kernel = hemisphere(64, true);
    const float radius = 0.5f, bias = 0.025f;
    const vec3 p = drawn.positionAt(x, y), n = drawn.normalAt(x, y);
    const vec3 t = tangentOf(n, noiseAt(x, y));
    const glm::mat3 tbn(t, glm::cross(n, t), n);
    float sum = 0;
    for (const vec3& k : kernel) {
        const vec3 s = p + tbn * k * radius;
        const float seen = drawn.seenBehind(s, false).z;
        const float near = smooth(radius / std::fabs(p.z - seen));
        sum += (seen >= s.z + bias ? 1.0f : 0.0f) * near;
    }
    return 1 - sum / 64;
}

float gedge(const Drawn& drawn, int x, int y)
{
    static const std::vector<vec3> kernel = hemisphere(16, true);
    const float radius = 0.5f, power = 2;
    const vec3 p = drawn.positionAt(x, y), n = drawn.normalAt(x, y);
    const vec3 t = tangentOf(n, noiseAt(x, y));
    const glm::mat3 basis(t, glm::cross(t, n), n);
    float occlusion = 0;
    for (const vec3& k : kernel) {
        const vec3 s = p + basis * k * radius;
        const float seen = drawn.seenBehind(s, false).z;
        occlusion += smooth(radius / std::fabs(p.z - seen)) * (seen > s.z ? 1.0f : 0.0f);
    }
    return std::pow(1 - occlusion / 16, power);
}

float lettier(const Drawn& drawn, int x, int y)
{
    static const std::vector<vec3> kernel = hemisphere(8, true);
    const float radius = 1, bias = 0.01f, magnitude = 1.5f, contrast = 1.5f;
    const vec3 p = drawn.positionAt(x, y), n = drawn.normalAt(x, y);
    const vec3 t = tangentOf(n, noiseAt(x, y));
    const glm::mat3 tbn(t, glm::cross(n, t), n);
    float open = 8;
    for (const vec3& k : kernel) {
        const vec3 s = p + tbn * k * radius;
        const float seen = -drawn.seenBehind(s, true).z;  // distances
        const float occluded = -s.z + bias <= seen ? 0.0f : 1.0f;
        open -= occluded * smooth(radius / std::fabs(-p.z - seen));
    }
    const float bent = std::pow(open / 8, magnitude);
    return glm::clamp(contrast * (bent - 0.5f) + 0.5f, 0.0f, 1.0f);
}

float thesis(const Drawn& drawn, int x, int y)
{
    static const std::vector<vec3> kernel = hemisphere(32, false);
    const float radius = 0.5f, bias = 0.0125f, most = 0.5f;
    const vec3 p = drawn.positionAt(x, y), n = drawn.normalAt(x, y);
    const vec3 t = tangentOf(n, noiseAt(x, y));
    const glm::mat3 basis(t, glm::cross(t, n), n);
    float sum = 0;
    for (const vec3& k : kernel) {
        const vec3 s = p + basis * k * radius;
        const float seen = drawn.seenBehind(s, false).z;
        if (seen >= s.z + bias && std::fabs(p.z - seen) < most) sum += 1;
    }
    const float open = 1 - sum / 32;
    return open * open;
}

float habr(const Drawn& drawn, int x, int y)
{
    static const std::vector<vec3> kernel = hemisphere(16, true);
    const float radius = 0.5f, normal_bias = 0.025f;
    const vec3 n = drawn.normalAt(x, y), p = drawn.positionAt(x, y) + n * normal_bias;
    const vec3 t = tangentOf(n, noiseAt(x, y));
    const glm::mat3 tbn(t, glm::cross(n, t), n);
    float blocked = 0;
    for (const vec3& k : kernel) {
        const vec3 s = p + tbn * k * radius;
        const float penetration = drawn.seenBehind(s, false).z - s.z;
        if (penetration >= 0) blocked += std::max(1 - penetration / radius, 0.0f);
    }
    return 1 - blocked / 16;
}

const Author kAuthors[] = {{"ogldev45", false, ogldev}, {"learnopengl", false, learnopengl},
                           {"gedge", true, gedge},      {"lettier", false, lettier},
                           {"thesis", false, thesis},   {"habr", true, habr}};

/// A target of a config, as it is before its filter.
Image targetOf(SceneRig& rig, const std::string& config, const char* name)
{
    return rig.draw(showing(descriptionOf({config}), name), rig.frame(), "shown");
}

Drawn draw(SceneRig& rig, const Author& author)
{
    const std::string surface = author.from_depth ? "lettier" : author.config;
    return {targetOf(rig, surface, "position"), targetOf(rig, surface, "normal"),
            targetOf(rig, author.config, "ao"), rig.frame().camera.clip_from_view};
}

/// The mean of 4x4 pixels.
Image boxed(const Image& image)
{
    Image mean(kSize, 1);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            float sum = 0;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i)
                    sum += image.at(std::min(x + i, kSize.width - 1),
                                    std::min(y + j, kSize.height - 1));
            mean.at(x, y) = sum / 16;
        }
    return mean;
}

double rmseOf(const Author& author, const Drawn& drawn)
{
    Image port(kSize, 1, 1.0f);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
            if (drawn.surfaceAt(x, y)) port.at(x, y) = author.visibility(drawn, x, y);
    const Image ours = boxed(drawn.ao), theirs = boxed(port);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            if (!drawn.surfaceAt(x, y)) continue;
            const double off = ours.at(x, y) - theirs.at(x, y);
            sum += off * off;
            ++count;
        }
    return std::sqrt(sum / count);
}

/// One direction of the thesis' filter: of two neighbours on either side those that differ by less
/// than `cut` in depth, weighted by a Gaussian whose window ends at two sigma.
Image filteredAlong(const Image& ao, const Drawn& drawn, int across, int down, float cut)
{
    Image mean(kSize, 1, 1.0f);
    for (int y = 2; y < kSize.height - 2; ++y)
        for (int x = 2; x < kSize.width - 2; ++x) {
            float sum = 0, weights = 0;
            for (int i = -2; i <= 2; ++i) {
                const int u = x + i * across, v = y + i * down;
                const float off = drawn.positionAt(u, v).z - drawn.positionAt(x, y).z;
                if (!drawn.surfaceAt(u, v) || std::fabs(off) >= cut) continue;
                const float weight = std::exp(-0.5f * float(i * i) * 4 / 9);
                sum += weight * ao.at(u, v);
                weights += weight;
            }
            if (weights > 0) mean.at(x, y) = sum / weights;
        }
    return mean;
}

}  // namespace

TEST_CASE("The thesis' filter counts neighbours by their difference in depth alone")
{
    SceneRig rig("room", kSize);
    for (const char* scene : {"room", "spheres", "plane"}) {
        rig.show(scene);
        const Drawn drawn = draw(rig, kAuthors[4]);
        const float cut = 0.1f * 0.5f;
        const Image across = filteredAlong(drawn.ao, drawn, 1, 0, cut);
        const Image theirs = filteredAlong(across, drawn, 0, 1, cut);
        const Image ours = targetOf(rig, "thesis", "ao_filtered");
        INFO(scene);
        for (int y = 4; y < kSize.height - 4; ++y)
            for (int x = 4; x < kSize.width - 4; ++x)
                if (drawn.surfaceAt(x, y))
                    REQUIRE(ours.at(x, y) == Approx(theirs.at(x, y)).margin(2.01f / 255));
    }
}

TEST_CASE("Configs of single authors draw what those authors compute")
{
    SceneRig rig("room", kSize);
    for (const char* scene : {"room", "corner", "spheres", "plane"}) {
        rig.show(scene);
        for (const Author& author : kAuthors) {
            INFO(author.config << " over " << scene);
            CHECK(rmseOf(author, draw(rig, author)) < author.limit());
        }
    }
}

}  // namespace crevice
