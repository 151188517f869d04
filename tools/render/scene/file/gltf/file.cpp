// SPDX-License-Identifier: MIT
// Chunks, limits and tinygltf, which is told of less than some files have: it refuses a byte order
// mark, chunks and buffers with some bytes too many, types of data URIs, and buffers that are only
// a fallback.
#include "tools/render/scene/file/gltf/file.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/render/scene/file/folder.h"

namespace crevice {

namespace {

namespace fs = std::filesystem;

const json kNull;

std::uint32_t littleEndian(std::string_view bytes)
{
    std::uint32_t value = 0;
    for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
    return value;
}

std::string littleEndian(std::uint32_t value)
{
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

constexpr std::size_t kHead = 12, kChunkHead = 8;

struct Chunks {
    std::string text, binary;
};

// The JSON and the binary chunk of a .glb file; the whole of a .gltf file.
Result<Chunks> chunksOf(const std::string& path)
{
    FileBytes file = readBytes(path, std::numeric_limits<std::uint32_t>::max());
    if (!file) return brokenScene(path, file.failure);
    Chunks chunks;
    std::string_view rest = file.bytes;
    if (!startsWith(rest, "glTF")) {
        chunks.text = std::move(file.bytes);  // with or without a byte order mark
        return chunks;
    }
    if (rest.size() < kHead) throw BrokenGltf("it ends within its header");
    if (littleEndian(rest.substr(4)) != 2)
        throw BrokenGltf("it is of glTF " + std::to_string(littleEndian(rest.substr(4))) +
                         ".0, not 2.0");
    rest.remove_prefix(kHead);
    while (rest.size() >= kChunkHead) {
        const std::uint64_t length = littleEndian(rest), size = file.bytes.size();
        const std::string_view type = rest.substr(4, 4);
        rest.remove_prefix(kChunkHead);
        if (length > rest.size())
            return overLimit(path, "bytes in its chunks",
                             static_cast<double>(size - rest.size() + length),
                             static_cast<double>(size), size);
        std::string& chunk = type == "JSON" ? chunks.text : chunks.binary;
        const bool known = type == "JSON" || type == std::string_view("BIN\0", 4);
        if (known && chunk.empty()) chunk = rest.substr(0, length);
        rest.remove_prefix(length);
    }
    if (chunks.text.empty()) return brokenScene(path, "it has no chunk of JSON");
    return chunks;
}

bool isData(const json& uri)
{
    return uri.is_string() && startsWith(uri.get<std::string>(), "data:");
}

// Of the file and its buffers; what is not found has the bytes that it says.
double bytesOf(const json& gltf, const std::string& path, std::uint64_t size)
{
    auto bytes = static_cast<double>(size);
    for (const json& buffer : member(gltf, "buffers")) {
        const json& uri = member(buffer, "uri");
        if (!uri.is_string() || isData(uri)) continue;
        std::error_code error;
        const auto name = percentDecoded(uri.get<std::string>());
        const std::uintmax_t found = fs::file_size(fs::path(path).parent_path() / name, error);
        bytes += error ? numberOf(member(buffer, "byteLength"), 0) : static_cast<double>(found);
    }
    return bytes;
}

// What the file would unfold to, before it does. A node is drawn once, however often it is named.
Status checkClaims(const json& gltf, const std::string& path, double bytes)
{
    const auto size = static_cast<std::uint64_t>(std::min(bytes, 1e18));
    const SceneLimits limits = sceneLimits(size);
    double elements = 0, primitives = 0, triangles = 0;
    for (const json& accessor : member(gltf, "accessors"))
        elements = std::max(elements, numberOf(member(accessor, "count"), 0));
    for (const json& mesh : member(gltf, "meshes"))
        for (const json& each : member(mesh, "primitives")) {
            const json& indices = member(each, "indices");
            const json& corners =
                indices.is_null() ? member(member(each, "attributes"), "POSITION") : indices;
            const double count =
                numberOf(member(entryOf(member(gltf, "accessors"), corners), "count"), 0);
            const bool apart = numberOf(member(each, "mode"), 4) <= 4;  // no strip and no fan
            triangles += apart ? count / 3 : count;
            primitives += 1;
        }
    const json& lights = member(extensionOf(gltf, "KHR_lights_punctual"), "lights");
    const std::tuple<const char*, double, double> counts[] = {
        {"elements in an accessor", elements, 3 * limits.triangles},
        {"primitives", primitives, limits.parts},
        {"triangles", triangles, limits.triangles},
        {"lights", static_cast<double>(lights.size()), limits.parts}};
    for (const auto& [what, count, limit] : counts)
        if (count > limit) return overLimit(path, what, count, limit, size);
    return {};
}

// A buffer as tinygltf reads it: of the length that its bytes have, where those are enough.
void mendBuffer(json& buffer, const std::string& path, std::size_t binary_size)
{
    const double length = numberOf(member(buffer, "byteLength"), 0);
    const json uri = member(buffer, "uri");
    if (!uri.is_string()) {
        if (binary_size > 0 && length <= static_cast<double>(binary_size)) return;
        // A fallback that nothing but an old reader needs, or else one whose views read too far.
        buffer["uri"] = octets("data:,AA==");
        buffer["byteLength"] = 1;
        return;
    }
    const auto text = uri.get<std::string>();
    if (isData(uri)) {
        buffer["uri"] = octets(text);
        std::string_view digits = text;
        digits.remove_prefix(text.find(',') + 1);
        while (!digits.empty() && digits.back() == '=') digits.remove_suffix(1);
        const std::size_t bytes = digits.size() * 3 / 4;
        if (length <= static_cast<double>(bytes)) buffer["byteLength"] = bytes;
        return;
    }
    std::error_code error;
    const auto file = fs::path(path).parent_path() / percentDecoded(text);
    const std::uintmax_t found = fs::file_size(file, error);
    if (!error && length <= static_cast<double>(found)) buffer["byteLength"] = found;
}

// Without images, and without indices of primitives whose own are Draco's.
std::string forTinygltf(json gltf, const std::string& path, std::size_t binary_size)
{
    gltf.erase("images");
    for (json& buffer : gltf["buffers"])
        if (buffer.is_object()) mendBuffer(buffer, path, binary_size);
    if (gltf["buffers"].is_null()) gltf.erase("buffers");
    for (json& mesh : gltf["meshes"])
        for (json& primitive : mesh.is_object() ? mesh["primitives"] : mesh)
            if (!extensionOf(primitive, "KHR_draco_mesh_compression").is_null())
                primitive.erase("indices");
    if (gltf["meshes"].is_null()) gltf.erase("meshes");
    return gltf.dump(-1, ' ', false, json::error_handler_t::replace);
}

bool exists(const std::string& file, void* user)
{
    SceneFolder& folder = *static_cast<SceneFolder*>(user);
    return !folder.refuses(file) && folder.allows(file);
}

std::string sameName(const std::string& file, void*) { return file; }

bool readWhole(std::vector<unsigned char>* bytes, std::string* error, const std::string& path,
               void* user)
{
    static_cast<SceneFolder*>(user)->opens(path);
    const FileBytes file = readBytes(path, std::numeric_limits<std::uint32_t>::max());
    *error = file.failure;
    bytes->assign(file.bytes.begin(), file.bytes.end());
    return static_cast<bool>(file);
}

std::string padded(std::string bytes, char with)
{
    bytes.resize((bytes.size() + 3) / 4 * 4, with);
    return bytes;
}

// As a .glb file, in which buffers that have no URI are allowed.
void readModel(std::string text, std::string data, const std::string& path, SceneFolder& folder,
               tinygltf::Model& model)
{
    const auto chunk = [](std::string& glb, std::string_view type, std::string bytes) {
        glb += littleEndian(static_cast<std::uint32_t>(bytes.size()));
        (glb += type) += bytes;
    };
    std::string glb;
    glb.reserve(text.size() + data.size() + 64);
    glb = "glTF" + littleEndian(2) + littleEndian(0);
    chunk(glb, "JSON", padded(std::move(text), ' '));
    if (!data.empty()) chunk(glb, {"BIN\0", 4}, padded(std::move(data), '\0'));
    glb.replace(8, 4, littleEndian(static_cast<std::uint32_t>(glb.size())));
    tinygltf::TinyGLTF reader;
    reader.SetFsCallbacks({exists, sameName, readWhole, nullptr, &folder});
    std::string error, warning;
    const bool read = reader.LoadBinaryFromMemory(
        &model, &error, &warning, reinterpret_cast<const unsigned char*>(glb.data()),
        static_cast<unsigned>(glb.size()), fs::path(path).parent_path().string());
    if (!read) throw BrokenGltf(error.empty() ? "tinygltf does not say why" : error);
}

}  // namespace

const json& member(const json& object, const std::string& name)
{
    if (!object.is_object()) return kNull;
    const auto found = object.find(name);
    return found == object.end() ? kNull : *found;
}

std::string octets(const std::string& data_uri)
{
    const std::size_t comma = data_uri.find(',');
    if (comma == data_uri.npos) throw BrokenGltf("a data URI has no comma");
    return "data:application/octet-stream;base64," + data_uri.substr(comma + 1);
}

const json& extensionOf(const json& object, const std::string& name)
{
    return member(member(object, "extensions"), name);
}

const json& entryOf(const json& list, int index)
{
    const bool there = list.is_array() && index >= 0 && std::size_t(index) < list.size();
    return there ? list[std::size_t(index)] : kNull;
}

const json& entryOf(const json& list, const json& index) { return entryOf(list, indexOf(index)); }

double numberOf(const json& value, double otherwise)
{
    const double number = value.is_number() ? value.get<double>() : otherwise;
    return std::isfinite(number) ? number : otherwise;
}

int indexOf(const json& value)
{
    const double number = numberOf(value, -1);
    return number >= 0 && number < 2e9 ? static_cast<int>(number) : -1;
}

Result<GltfFile> GltfFile::parse(const std::string& path)
{
    Result<Chunks> chunks = chunksOf(path);
    if (!chunks) return chunks.diagnostics();
    GltfFile file;
    file.binary_ = std::move(chunks->binary);
    try {
        file.document_ = json::parse(chunks->text);
    } catch (const json::parse_error& error) {
        const std::string what = error.what();  // "[json.exception.parse_error.101] parse error at"
        throw BrokenGltf(what.substr(std::min(what.find("] ") + 2, what.size())));
    }
    if (!file.document_.is_object()) throw BrokenGltf("its JSON is no object");
    return file;
}

Status GltfFile::load(const std::string& path, SceneFolder& folder)
{
    const double bytes = bytesOf(document_, path, folder.bytes());
    if (Status fits = checkClaims(document_, path, bytes); !fits) return fits;
    std::string text = forTinygltf(document_, path, binary_.size());  // before its bytes are moved
    readModel(std::move(text), std::move(binary_), path, folder, model_);
    return {};
}

}  // namespace crevice
