// SPDX-License-Identifier: MIT
// crevice bake: a config as what a program carries, plans and shaders without the compiler.
#include "tools/bake/bake.h"

#include "core/base/text.h"
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/options.h"
#include "tools/render/scene_upload.h"
#include "tools/show/plan/planning.h"

#include <crevice/governor.h>
#include <crevice/recording_device.h>

#include <CLI/CLI.hpp>

namespace crevice {
namespace {

struct BakeArguments {
    ConfigOptions config;
    SceneOptions scene;
    std::vector<std::string> configs;
    std::vector<std::string> values, traits;
    std::string front;
    std::string out;
    std::string header;
    BakeOptions bake;
};

/// "display=lit,no_ao". Errors: CV8001.
Status readValues(const char* option, const std::vector<std::string>& texts,
                  std::vector<BakeValues>& into)
{
    for (const std::string& text : texts) {
        const Result<NamedFile> named =
            parseNamedFile(option, text, "write " + std::string(option) + " display=lit,no_ao");
        if (!named) return named.diagnostics();
        BakeValues& values = into.emplace_back(BakeValues{named->name, {}});
        for (const std::string_view value : split(named->file, ','))
            values.values.emplace_back(value);
    }
    return {};
}

Result<SceneTraits> traitsOfScene(const SceneOptions& options)
{
    if (options.scene.empty()) return usualTraits();
    const Result<SceneView> view = loadSceneView(options);
    if (!view) return view.diagnostics();
    RecordingDevice device;
    const Result<UploadedScene> scene = UploadedScene::upload(device, view->scene);
    if (!scene) return scene.diagnostics();
    return traitsOf(makeFrame(*scene, view->camera, view->extent));
}

/// The configs, or a front's levels.
Result<std::vector<BakeRequest>> readRequests(const BakeArguments& arguments)
{
    const CheckoutSources sources(arguments.config.checkout, arguments.config.roots);
    std::vector<BakeRequest> requests;
    for (const std::string& config : arguments.configs) requests.push_back({config});
    if (!arguments.front.empty()) {
        const Result<std::vector<FrontLevel>> levels = readFront(arguments.front);
        if (!levels) return levels.diagnostics();
        for (const FrontLevel& level : *levels)
            requests.push_back({level.name, level.set, level.ms, level.error});
    }
    if (requests.empty())
        return Diagnostic{Code::usage, "there is nothing to bake",
                          "name a config, or write --front FILE for the levels of a governor"};
    for (BakeRequest& each : requests) {
        ConfigOptions config = arguments.config;
        config.config = each.name;
        each.set.insert(each.set.end(), config.overrides.begin(), config.overrides.end());
        config.overrides = each.set;
        Result<Description> description = loadDescription(config, sources);
        if (!description) return description.diagnostics();
        each.description = std::move(*description);
    }
    return requests;
}

int bakeCommand(BakeArguments& arguments)
{
    const std::string& file = arguments.header.empty() ? arguments.out : arguments.header;
    if (file.empty() || (!arguments.header.empty() && !arguments.out.empty()))
        return report({Diagnostic{Code::usage, "one file must be written",
                                  "write --out effect.crevice, or --header effect.h"}},
                      false);
    Status status = checkWritable(file);
    if (status) status = readValues("--values", arguments.values, arguments.bake.values);
    if (status) status = readValues("--trait", arguments.traits, arguments.bake.traits);
    if (!status) return report(status.diagnostics(), false);
    const Result<SceneTraits> scene = traitsOfScene(arguments.scene);
    if (!scene) return report(scene.diagnostics(), false);
    arguments.bake.scene = *scene;
    const Result<std::vector<BakeRequest>> requests = readRequests(arguments);
    if (!requests) return report(requests.diagnostics(), false);
    const Result<std::string> bytes = bake(*requests, arguments.bake);
    if (!bytes) return report(bytes.diagnostics(), false);
    std::string name = std::filesystem::path(file).stem().string();
    for (char& c : name) c = isWord(c) ? c : '_';
    if (name.empty() || isDigit(name[0])) name.insert(0, "baked_");
    const Status written =
        writeFile(file, arguments.header.empty() ? *bytes : asHeader(*bytes, name));
    if (!written) return report(written.diagnostics(), false);
    report(bytes.diagnostics(), false);
    const Result<std::vector<BakedConfig>> baked = readBaked(bytes->data(), bytes->size());
    if (!baked) return report(baked.diagnostics(), false);
    for (const BakedConfig& each : *baked)
        printMessage("%s: %zu plans of %zu programs, outputs %s\n",
                     printableLine(each.name).c_str(), each.plan_count, each.program_count,
                     joined(namesOf(each.description.outputs)).c_str());
    printMessage("wrote %s (%zu bytes)\n", printableLine(file).c_str(), bytes->size());
    return kExitOk;
}

}  // namespace

void addBakeCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command =
        app.add_subcommand("bake", "Write what a program carries that links crevice::runtime");
    auto arguments = std::make_shared<BakeArguments>();
    arguments->scene.scene.clear();
    command->add_option("CONFIG", arguments->configs, "Shipped configs' names, or files");
    addConfigOptions(*command, arguments->config);
    addList(*command, "--output", arguments->bake.outputs, "NAME",
            "Bake for this output; may be repeated. Default: all but those on request");
    addList(*command, "--values", arguments->values, "NAME=VALUE,...",
            "Bake for these words of a feature, or values of a param that decides what is "
            "compiled; may be repeated. Default: the value that the config has");
    addList(*command, "--trait", arguments->traits, "NAME=VALUE,...",
            "Bake for scenes and cameras of this kind: camera.reversed_depth=true,false; may be "
            "repeated. Default: as --scene is");
    addSceneOptions(*command, arguments->scene);
    addText(*command, "--front", arguments->front, "FILE",
            "Bake the levels of a governor, as crevice choose --write-front writes them");
    addText(*command, "--out", arguments->out, "FILE", "The baked effect: effect.crevice");
    addText(*command, "--header", arguments->header, "FILE", "... or the same as a C header");
    command->footer(
        "Examples:\n"
        "  crevice bake mobile+geometry/host_depth --output ao --header mobile_ao.h\n"
        "  crevice bake quality --values quality=low,medium,high --out quality.crevice\n"
        "  crevice bake --front front.json --output ao --out levels.crevice");
    command->callback([arguments, &exit_code] { exit_code = bakeCommand(*arguments); });
}

}  // namespace crevice
