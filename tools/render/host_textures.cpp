// SPDX-License-Identifier: MIT
#include "tools/render/host_textures.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/image_metrics.h"

namespace crevice {
namespace {

const char* const kHostModule = "command/host.json";

template <class T>
T* named(std::vector<T>& all, const std::string& name)
{
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const T& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

bool isDepth(Format format) { return formatInfo(format).format_class == FormatClass::depth; }

/// Puts the output into the format of the import. A depth format is right for window depth alone;
/// other imports leave it as the key's default.
void fitFormat(Description& host, const ImportDesc& import, const DeviceCaps& caps)
{
    OutputDesc& output = *named(host.outputs, import.name);
    const Format format = formatFromName(import.format);
    const bool window = import.name == "depth";
    if (isDepth(format) && !window) return;
    if (!isDepth(format) && window) output.target.name = "host_depth";
    if (!caps.canRender(format)) return;
    std::vector<Format>& formats = named(host.targets, output.target.name)->formats;
    formats.insert(formats.begin(), format);
}

/// What both have a param of, such as the far plane of logarithms.
void takeParams(Description& host, const Description& description)
{
    for (const ParamDesc& param : description.params)
        if (ParamDesc* own = named(host.params, param.name))
            if (param.name != "guard_band") own->value = param.value;
}

bool lacks(const Frame& scene, const ImportDesc& import)
{
    return import.type == ImportType::texture && !findNamed(scene.textures, import.name);
}

}  // namespace

Status HostTextures::readPicture(Device& device, const ImportDesc& import, const std::string& path)
{
    const Result<Image> image = readImage(path);
    if (!image) return image.diagnostics();
    const Format format = formatFromName(import.format);
    const auto texture = device.createTexture({import.name, format, image->extent});
    if (!texture) return texture.diagnostics();
    pictures_.push_back({import.name, path, Owned<TextureId>(device, *texture)});
    return device.writeTexture(*texture, withChannels(*image, formatInfo(format).channels));
}

/// Beside that file, if it is one on disk. Where there is no such picture, nothing comes of it: the
/// renderer reports a texture that lacks.
Status HostTextures::readBeside(Device& device, const ImportDesc& import, const SourceRef& source)
{
    const bool found = findNamed(pictures_, import.name);
    if (found || !source || !source->path.empty()) return {};
    for (const char* const extension : {".png", ".hdr", ".exr"}) {
        const std::string path =
            std::filesystem::path(source->name).replace_filename(import.name + extension).string();
        if (const Status allowed = mayName(*source, path); !allowed) {
            Diagnostic error = allowed.diagnostics().front();
            error.place = import.place;
            error.pointer = import.pointer;
            return error;
        }
        if (!readStart(path, 0).missing) return readPicture(device, import, path);
    }
    return {};
}

Status HostTextures::readFiles(Device& device, const Description& description,
                               const std::vector<std::string>& files)
{
    std::vector<std::string> names;
    for (const ImportDesc& each : description.imports)
        if (each.type == ImportType::texture) names.push_back(each.name + "=FILE");
    const std::string ways =
        names.empty() ? "the config imports no textures" : "write --texture " + joined(names);
    for (const std::string& text : files) {
        const Result<NamedFile> given = parseNamedFile("--texture", text, ways);
        if (!given) return given.diagnostics();
        const ImportDesc* import = findNamed(description.imports, given->name);
        if (!import || import->type != ImportType::texture)
            return Diagnostic{Code::usage,
                              "--texture '" + text + "' is for no import of the config", ways};
        if (const Status read = readPicture(device, *import, given->file); !read) return read;
    }
    return {};
}

Result<HostTextures> HostTextures::make(Device& device, const Description& description,
                                        Extent extent, const Frame& scene,
                                        const std::vector<std::string>& files)
{
    const std::vector<ImportDesc>& imports = description.imports;
    HostTextures textures;
    if (const Status read = textures.readFiles(device, description, files); !read)
        return read.diagnostics();
    if (!anyOf(imports, [&](const ImportDesc& each) { return lacks(scene, each); }))
        return textures;
    Result<Description> host = loadDescription({kHostModule, {}, {}, {}}, shippedSources());
    if (!host) return host.diagnostics();
    bool draws = false;
    for (const ImportDesc& import : imports) {
        draws |= import.type == ImportType::draw_list;
        if (!lacks(scene, import) || findNamed(textures.pictures_, import.name)) continue;
        if (!findNamed(host->outputs, import.name)) {
            for (const SourceRef& file : {import.place.source, description.place.source})
                if (const Status read = textures.readBeside(device, import, file); !read)
                    return read.diagnostics();
            continue;
        }
        textures.names_.push_back(import.name);
        fitFormat(*host, import, device.caps());
    }
    if (textures.names_.empty()) return textures;
    textures.draws_ = draws;
    takeParams(*host, description);
    auto renderer =
        Renderer::create(device, std::move(*host), {extent, textures.names_, {}}, traitsOf(scene));
    if (!renderer) return renderer.diagnostics();
    textures.renderer_ = std::move(*renderer);
    return textures;
}

Result<Frame> HostTextures::frameOf(const Frame& scene)
{
    Frame frame = scene;
    for (const Picture& picture : pictures_)
        frame.textures.push_back({picture.name, picture.texture.id()});
    if (!renderer_) return frame;
    if (const Status drawn = renderer_->render(scene); !drawn) return drawn.diagnostics();
    const auto texturesOf = [&](int view, std::vector<ImportedTexture>& textures) {
        for (const std::string& name : names_)
            textures.push_back({name, renderer_->output(name, view)});
    };
    texturesOf(0, frame.textures);
    for (std::size_t i = 0; i < frame.other_views.size(); ++i)
        texturesOf(static_cast<int>(i) + 1, frame.other_views[i].textures);
    if (!draws_) {
        frame.draws.clear();
        frame.materials.clear();
    }
    return frame;
}

Status Drawn::prepare(Device& device, const Description& description, const Frame& scene,
                      const CompileOptions& options)
{
    Result<HostTextures> handed = HostTextures::make(device, description, options.extent, scene);
    if (!handed) return handed.diagnostics();
    host.emplace(std::move(*handed));
    if (const Status handed_over = handOver(scene); !handed_over) return handed_over;
    if (renderer) return renderer->resize(options.extent);
    auto made = Renderer::create(device, description, options, traitsOf(frame));
    if (!made) return made.diagnostics();
    renderer = std::move(*made);
    return {};
}

Status Drawn::handOver(const Frame& scene)
{
    Result<Frame> hosted = host->frameOf(scene);
    if (hosted) frame = std::move(*hosted);
    return hosted.diagnostics();
}

void Drawn::rest()
{
    host.reset();
    frame = {};
    if (renderer && !renderer->resize({1, 1})) renderer.reset();
}

}  // namespace crevice
