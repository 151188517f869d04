// SPDX-License-Identifier: MIT
#include "effects/c_api/textures.h"

#include "effects/c_api/structs.h"

namespace crevice {

namespace {

/// Errors: CV6011 for a name that is no format's, and for an unknown kind.
Status checkTexture(const crevice_texture& texture)
{
    if (texture.format && formatFromName(texture.format) == Format::none)
        return Diagnostic{Code::bad_input,
                          "there is no format '" + std::string(texture.format) + "'",
                          suggestName(texture.format, formatNames(), "formats")};
    const int kind = numberOf(texture.kind);
    if (kind >= CREVICE_TEXTURE && kind <= CREVICE_FRAMEBUFFER) return {};
    return Diagnostic{Code::bad_input, "there is no texture kind " + std::to_string(kind),
                      "take one of crevice_texture_kind, such as CREVICE_LAYER"};
}

HostTexture::Kind kindOf(crevice_texture_kind kind)
{
    switch (kind) {
    case CREVICE_LAYER: return HostTexture::Kind::layer;
    case CREVICE_RENDERBUFFER: return HostTexture::Kind::renderbuffer;
    case CREVICE_FRAMEBUFFER: return HostTexture::Kind::framebuffer;
    default: return HostTexture::Kind::texture;
    }
}

}  // namespace

Status takeTexture(const crevice_texture* given, HostTexture& host)
{
    crevice_texture texture = {};
    Status status = take(given, "crevice_texture", texture);
    if (status) status = checkTexture(texture);
    if (!status) return status;
    host.name = texture.name;
    host.format = texture.format ? formatFromName(texture.format) : Format::none;
    host.extent = {texture.width, texture.height};
    host.samples = texture.samples == 0 ? 1 : texture.samples;
    host.kind = kindOf(texture.kind);
    host.layer = texture.layer;
    host.part = texture.part;
    host.x = texture.x;
    host.y = texture.y;
    return status;
}

}  // namespace crevice
