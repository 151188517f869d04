// SPDX-License-Identifier: MIT
#include "backends/gl/program_cache.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

namespace crevice {

namespace {

/// What stands before the driver's bytes. Some drivers crash on bytes that are not theirs, so that
/// they see none whose checksum is wrong.
struct Header {
    std::uint32_t magic = 0x31425043;  // "CPB1"; another number for another layout
    std::uint32_t format = 0;          // the driver's own
    std::uint64_t checksum = 0;        // over key, format, length and bytes
};

std::uint64_t checksumOf(const std::string& key, const Header& header, std::string_view binary)
{
    ContentHash hash;
    hash.addText(key);
    hash.add(header.format);
    hash.addText(binary);
    return hash.value();
}

std::string_view binaryIn(const std::vector<std::uint8_t>& kept)
{
    return {reinterpret_cast<const char*>(kept.data()) + sizeof(Header),
            kept.size() - sizeof(Header)};
}

/// Clears the GL errors of this file's calls; a lost context will report its error again.
bool leftErrors(GlApi& gl) { return !takeErrors(gl, "a program binary").ok(); }

}  // namespace

GlProgramCache::GlProgramCache(const GlApi& gl, ProgramCache host) : host_(std::move(host))
{
    if (!gl.GetProgramBinary || !gl.ProgramBinary || !gl.ProgramParameteri) return;
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
    if (count <= 0) return;
    formats_.resize(count);
    gl.GetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats_.data());
    for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) {
        const GLubyte* text = gl.GetString(name);
        driver_.addText(text ? reinterpret_cast<const char*>(text) : "");
    }
}

std::string GlProgramCache::key(const ProgramDesc& desc) const
{
    if (!loads() && !stores()) return {};
    ContentHash hash = driver_;
    hash.addText(desc.vertex.text);
    hash.addText(desc.fragment.text);
    return hash.hex();
}

GlProgram GlProgramCache::load(GlApi& gl, const std::string& key) const
{
    if (!loads()) return {};
    const std::vector<std::uint8_t> kept = host_.load(key);
    if (kept.size() <= sizeof(Header)) return {};
    Header header;
    std::memcpy(&header, kept.data(), sizeof(header));
    const std::string_view binary = binaryIn(kept);
    if (header.magic != Header().magic || header.checksum != checksumOf(key, header, binary) ||
        std::count(formats_.begin(), formats_.end(), static_cast<GLint>(header.format)) == 0)
        return {};
    GlProgram program(gl, gl.CreateProgram());
    gl.ProgramBinary(program.name(), header.format, binary.data(),
                     static_cast<GLsizei>(binary.size()));
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (leftErrors(gl) || !linked) return {};
    return program;
}

void GlProgramCache::announce(const GlApi& gl, GLuint program) const
{
    if (stores()) gl.ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
}

void GlProgramCache::store(GlApi& gl, const std::string& key, GLuint program) const
{
    if (!stores()) return;
    GLint length = 0;
    gl.GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
    std::vector<std::uint8_t> kept(sizeof(Header) + std::max(length, 0));
    Header header;
    GLsizei written = 0;
    if (length > 0)
        gl.GetProgramBinary(program, length, &written, &header.format,
                            kept.data() + sizeof(Header));
    if (leftErrors(gl) || written <= 0) return;
    kept.resize(sizeof(Header) + written);
    header.checksum = checksumOf(key, header, binaryIn(kept));
    std::memcpy(kept.data(), &header, sizeof(header));
    host_.store(key, kept);
}

}  // namespace crevice
