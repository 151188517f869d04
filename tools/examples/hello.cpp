// SPDX-License-Identifier: MIT
// Ambient occlusion from C++: depth of a floor that meets a wall goes in, the mean of AO comes out.
//
//     find_package(crevice REQUIRED)
//     target_link_libraries(hello PRIVATE crevice::backends crevice::effects GLESv2)
//
// An application has a context and a depth texture of its own, and begins at makeGlDevice.
#include <crevice/context.h>
#include <crevice/effect.h>
#include <crevice/gl_device.h>

#include <GLES3/gl3.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>

using namespace crevice;

namespace {

constexpr Extent kSize = {256, 144};
constexpr const char* kConfig = R"({ "format": 1, "name": "hello",
    "extends": ["geometry/host_depth", "ssao/gtao", "filter/bilateral_normal"] })";

/// Ends the program where something failed, and says why.
void need(const Status& status)
{
    if (status) return;
    std::fputs(toText(status.diagnostics()).c_str(), stderr);
    std::exit(EXIT_FAILURE);
}

template <class T>
T need(Result<T> result)
{
    if (!result) need(Status(result.diagnostics()));
    return std::move(*result);
}

glm::mat4 projection()
{
    return glm::perspective(glm::radians(60.0f), 1.0f * kSize.width / kSize.height, 0.1f, 100.0f);
}

/// Window depth of a row: the floor lies 1 below the camera, the wall 4 away.
double depthOfRow(int row)
{
    const double height = ((row + 0.5) / kSize.height * 2 - 1) * std::tan(glm::radians(30.0));
    const double distance = height < -0.25 ? -1 / height : 4;
    const glm::dvec4 clip = glm::dmat4(projection()) * glm::dvec4(0, 0, -distance, 1);
    return clip.z / clip.w * 0.5 + 0.5;
}

/// What an application draws its scene into.
GLuint makeDepth()
{
    std::vector<GLuint> pixels;
    for (int y = 0; y < kSize.height; ++y)
        pixels.insert(pixels.end(), kSize.width, static_cast<GLuint>(depthOfRow(y) * 4294967295.0));
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, kSize.width, kSize.height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize.width, kSize.height, GL_DEPTH_COMPONENT,
                    GL_UNSIGNED_INT, pixels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

void draw(Effect& effect, GLuint depth)
{
    effect.setProjection(glm::value_ptr(projection()));
    need(effect.setTexture("depth", depth, Format::depth24, kSize));
    need(effect.setParam("radius", 1.0f));
    need(effect.render());
}

/// An application binds `nativeName` and multiplies its ambient light by it.
double meanOf(Device& device, const Effect& effect)
{
    std::printf("texture %u\n", effect.nativeName("ao"));
    const Image ao = need(device.readTexture(effect.output("ao")));
    return std::accumulate(ao.pixels.begin(), ao.pixels.end(), 0.0) / ao.pixels.size();
}

}  // namespace

int main()
{
    const auto context = need(makeEglContext());
    const auto device = need(makeGlDevice(context->loader()));
    const GLuint depth = makeDepth();
    {
        Effect effect = need(Effect::create(*device, kConfig, kSize));
        draw(effect, depth);
        std::printf("mean AO %.4f\n", meanOf(*device, effect));
    }
    glDeleteTextures(1, &depth);
    return EXIT_SUCCESS;
}
