// SPDX-License-Identifier: MIT
// Scenes read in a process of their own: Assimp 5.2 asserts on some broken files and never returns
// from others.
#include "tools/render/scene/file/import.h"
#include "tools/render/scene/file/limits.h"
#include "tools/render/scene/scene_bytes.h"
#include "tools/render/scene/transfer.h"

#include <filesystem>

namespace crevice {
namespace {

// What goes through the pipe.
struct Answer {
    bool ok = false;
    Scene scene;
    Diagnostics diagnostics;
};

template <class Pipe>
void transfer(Pipe& pipe, Answer& answer)
{
    transferAll(pipe, answer.ok, answer.scene, answer.diagnostics);
}

Answer answerOf(const std::string& path, const ImportOptions& options)
{
    Answer answer;
    try {
        Result<Scene> scene = readScene(path, options);
        answer.ok = scene.ok();
        answer.diagnostics = scene.diagnostics();
        if (scene) answer.scene = std::move(*scene);
    } catch (const std::bad_alloc&) {
        answer.diagnostics = {brokenScene(
            path, "it takes more memory than it may, 768 MiB and 64 times the size of its files")};
        answer.diagnostics.front().help =
            "it may claim more than it holds; a scene that is this large has to be split";
    } catch (const std::exception& fault) {
        answer.diagnostics = {brokenScene(path, fault.what())};
    }
    return answer;
}

Diagnostic unfinished(ChildEnd end, const std::string& path, const ChildLimits& limits)
{
    if (end == ChildEnd::no_child)
        return {Code::out_of_memory, "there is no process to read the scene '" + path + "' in"};
    if (end == ChildEnd::crashed) {
        Diagnostic error = brokenScene(path, "its reader crashed");
        error.help = "the file is damaged; export it once more, or convert it to .glb";
        return error;
    }
    Diagnostic error = brokenScene(path, "that took longer than " +
                                             std::to_string(static_cast<long long>(limits.cpu_s)) +
                                             " s of the processor's time");
    error.help = "the file is damaged or very large; allow more time with --import-time SECONDS";
    return error;
}

Result<Scene> importApart(const std::string& path, const ImportOptions& options)
{
    std::error_code error;
    const ChildLimits limits = readerLimits(std::filesystem::file_size(path, error), options);
    std::string bytes;
    const auto send = [&](Sender& sender) {
        Answer read = answerOf(path, options);
        transfer(sender, read);
    };
    const ChildEnd end = runInChild(limits, send, bytes);
    if (end != ChildEnd::done) return unfinished(end, path, limits);
    Answer answer;
    BytesReader reader(bytes);
    transfer(reader, answer);
    if (!reader.whole()) return unfinished(ChildEnd::crashed, path, limits);
    if (!answer.ok) return answer.diagnostics;
    if (!isSound(answer.scene)) return brokenScene(path, "its reader mixed it up");
    return {std::move(answer.scene), std::move(answer.diagnostics)};
}

}  // namespace

Result<Scene> importScene(const std::string& path, const ImportOptions& options)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        return Diagnostic{Code::scene_missing, "the scene file '" + path + "' does not exist"};
    if (!std::filesystem::is_regular_file(path, error))
        return brokenScene(path, "it is not a file");
    if (!options.any_format && !isDefaultFormat(path)) {
        Diagnostic broken = brokenScene(path, "it is in none of the formats that are read");
        broken.help = std::string(kSceneFormats) + "; --any-format tries all that Assimp knows";
        return broken;
    }
    try {
        return importApart(path, options);
    } catch (const std::bad_alloc&) {
        return Diagnostic{Code::out_of_memory, "the scene '" + path + "' does not fit into memory"};
    }
}

}  // namespace crevice
