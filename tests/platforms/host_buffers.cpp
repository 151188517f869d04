// SPDX-License-Identifier: MIT
// Has the page of tools/examples/web keep its meshes in buffers of its own, and time its frames:
// what it makes as its device takes each mesh by adoptMesh, with 16-bit indices and without uv.
#include <crevice/gl_device.h>

#include "backends/gl/api.h"
#include "tools/render/device/forwarding_device.h"

#include <emscripten.h>

#include <cstddef>

namespace crevice {

namespace {

class BufferDevice final : public ForwardingDevice {
public:
    BufferDevice(std::unique_ptr<Device> device, const GlApi& gl)
        : ForwardingDevice(*device),
          owned_(std::move(device)),
          gl_(gl)
    {
    }

    const TimerId timer = createTimer();  // null where there is none

    Result<MeshId> createMesh(const MeshDesc& desc) override
    {
        const std::vector<std::uint16_t> indices(desc.indices.begin(), desc.indices.end());
        const std::uint32_t vertices = bufferOf(GL_ARRAY_BUFFER, desc.vertices);
        HostMesh host;
        host.label = desc.label;
        host.position = {vertices, VertexType::float32, offsetof(Vertex, position), sizeof(Vertex)};
        host.normal = {vertices, VertexType::float32, offsetof(Vertex, normal), sizeof(Vertex)};
        host.vertex_count = static_cast<std::uint32_t>(desc.vertices.size());
        host.index_buffer = bufferOf(GL_ELEMENT_ARRAY_BUFFER, indices);
        host.index_type = IndexType::uint16;
        host.index_count = static_cast<std::uint32_t>(indices.size());
        return adoptMesh(host);
    }

    Status beginFrame() override
    {
        Status status = ForwardingDevice::beginFrame();
        times_ = status.ok() && timer;
        if (times_) beginTimer(timer);
        return status;
    }
    Status endFrame() override
    {
        if (times_) endTimer();
        return ForwardingDevice::endFrame();
    }

private:
    template <class T>
    std::uint32_t bufferOf(GLenum target, const std::vector<T>& data) const
    {
        GLuint name = 0;
        gl_.GenBuffers(1, &name);
        gl_.BindBuffer(target, name);
        gl_.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(),
                       GL_STATIC_DRAW);
        gl_.BindBuffer(target, 0);
        return name;
    }

    std::unique_ptr<Device> owned_;
    GlApi gl_;
    bool times_ = false;
};

BufferDevice* device = nullptr;

}  // namespace

/// What main.cpp calls makeGlDevice here (CMakeLists.txt).
Result<std::unique_ptr<Device>> makeBufferDevice(const GlLoader& loader,
                                                 const GlDeviceOptions& options)
{
    const Result<GlApi> gl = loadGlApi(loader);
    if (!gl) return gl.diagnostics();
    auto made = makeGlDevice(loader, options);
    if (!made) return made.diagnostics();
    auto buffered = std::make_unique<BufferDevice>(std::move(*made), *gl);
    device = buffered.get();
    return std::unique_ptr<Device>(std::move(buffered));
}

/// What the last frame took on the GPU, in milliseconds: 0 while that is not known, and below
/// where it never will be.
extern "C" EMSCRIPTEN_KEEPALIVE double frameTime()
{
    if (device && !device->timer) return -1.0;
    return device && device->timerReady(device->timer) ? device->readTimer(device->timer) : 0.0;
}

}  // namespace crevice
