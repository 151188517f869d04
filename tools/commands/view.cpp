// SPDX-License-Identifier: MIT
// crevice view: serves the page on this machine, with one's own config and scene.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene/options.h"
#include "tools/render/scene/scene_bytes.h"
#include "tools/show/view/site.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <thread>

namespace crevice {
namespace {

struct ViewOptions {
    ConfigOptions config;
    std::string scene;  ///< Empty: what the page begins with.
    std::string camera;
    ImportOptions import;
    int port = 0;
    std::string page;  ///< Empty: the built one.
    bool no_browser = false;
};

/// Whether the page makes the scene itself.
bool pageHas(const std::string& scene)
{
    return contains(builtinSceneNames(), scene) && !needsFile(scene);
}

/// A model that was dropped on the page, without the files that it may name. It is read as any
/// other, from a folder of its own.
Result<std::string> readDropped(const ImportOptions& options, const std::string& name,
                                const std::string& file)
{
    namespace fs = std::filesystem;
    std::string folder = (fs::temp_directory_path() / "crevice_model_XXXXXX").string();
    if (!mkdtemp(folder.data()))
        return Diagnostic{Code::cannot_write, "there is no folder for temporary files",
                          "name one by the environment variable TMPDIR"};
    const std::string path = (fs::path(folder) / fs::path(name).filename()).string();
    Result<std::string> bytes = std::string();
    Diagnostics found = writeFile(path, file).diagnostics();
    if (found.empty()) {
        const Result<Scene> scene = loadScene(path, options);
        found = scene.diagnostics();
        if (scene) bytes = sceneBytes(*scene);
    }
    std::error_code error;
    fs::remove_all(folder, error);
    return hasErrors(found) ? Result<std::string>(found)
                            : Result<std::string>(std::move(*bytes), std::move(found));
}

/// What the page shows. A scene that is a file, or needs one, is read here, once.
Result<SiteView> loadView(const ViewOptions& options)
{
    SiteView view{options.config.variant, options.camera, options.scene, {}, {}};
    view.read = [import = options.import](const std::string& name, const std::string& file) {
        return readDropped(import, name, file);
    };
    if (options.scene.empty() || pageHas(options.scene)) return view;
    Progress progress;
    progress.begin("loading " + options.scene);
    const Result<Scene> scene = loadScene(options.scene, options.import);
    if (!scene) return scene.diagnostics();
    const Result<SceneCamera> camera = chooseCamera(*scene, scene->bounds(), options.camera, 1.0);
    if (!camera) return camera.diagnostics();
    view.scene_bytes = std::make_shared<const std::string>(sceneBytes(*scene));
    return {std::move(view), scene.diagnostics()};
}

/// Tells the pages of edits, and the terminal what is wrong after them, until it is interrupted.
void watch(UserFiles& files, Events& events)
{
    constexpr std::chrono::milliseconds kPause(100);  // below what a person notices after a save
    for (; !interrupted(); std::this_thread::sleep_for(kPause)) {
        const std::vector<UserFile> changes = files.changes();
        for (const UserFile& file : changes) events.push("file", fileEvent(file));
        if (!changes.empty()) report(files.check(), false);
    }
}

void showAddress(const std::string& address, bool no_browser)
{
    print("%s\n", address.c_str());
    if (!no_browser && !openBrowser(address))
        printMessage("there is no xdg-open: open that address in a browser\n");
    printMessage("serving on this machine alone; interrupt to end\n");
}

int view(const ViewOptions& options)
{
    Result<PageFiles> page = listPage(options.page.empty() ? builtPageFolder() : options.page);
    if (!page) return report(page.diagnostics(), false);
    UserFiles files(options.config, shippedSources());
    const Diagnostics config = files.check();
    report(config, false);  // of one's own file the page shows them, too
    if (hasErrors(config) && !files.editable()) return exitCodeOf(config);
    Result<SiteView> shown = loadView(options);
    report(shown.diagnostics(), false);
    if (!shown) return exitCodeOf(shown.diagnostics());

    const Result<std::string> token = randomToken();
    if (!token) return report(token.diagnostics(), false);
    Events events;
    Server server;
    const Result<int> port = server.bind(options.port);
    if (!port) return report(port.diagnostics(), false);
    Site site(*token, *port, std::move(*page), files, std::move(*shown));
    catchInterrupts();
    server.start(site, events);
    showAddress(site.address(), options.no_browser);
    watch(files, events);
    server.stop();
    return kExitOk;
}

}  // namespace

void addViewCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand(
        "view", "Show a config in a browser, with knobs, an editor and your scene");
    auto options = std::make_shared<ViewOptions>();
    options->config.config = "mobile";
    command->add_option("CONFIG", options->config.config, "A shipped config's name, or a file")
        ->capture_default_str();
    addSceneOption(*command, options->scene);
    addCameraOption(*command, options->camera);
    addVariantOption(*command, options->config.variant);
    addImportOptions(*command, options->import);
    addRootOption(*command, options->config.roots);
    command->add_option("--port", options->port, "Port of 127.0.0.1. Default: any that is free")
        ->type_name("N")
        ->check(CLI::Range(0, 65535));
    addText(*command, "--page", options->page, "FOLDER", "Folder of the built page");
    command->add_flag("--no-browser", options->no_browser, "Print the address and open no browser");
    command->footer(
        "Saving in the page writes the file, and saving in an editor updates the page. Only who\n"
        "knows the address, on this machine, sees anything.\n"
        "Examples:\n"
        "  crevice view\n"
        "  crevice view mine.json --scene model.glb\n"
        "  crevice view gtao --scene street --no-browser");
    command->callback([options, &exit_code] { exit_code = view(*options); });
}

}  // namespace crevice
