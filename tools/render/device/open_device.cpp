// SPDX-License-Identifier: MIT
#include "tools/render/device/open_device.h"

#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"

#include <CLI/CLI.hpp>

namespace crevice {
namespace {

Result<OpenDevice> openNamed(std::string_view backend, const GlDeviceOptions& options)
{
    Result<std::unique_ptr<Context>> context = makeContext(backend);
    if (!context) return context.diagnostics();
    Result<std::unique_ptr<Device>> device = makeGlDevice((*context)->loader(), options);
    if (!device) return device.diagnostics();
    return {OpenDevice{std::move(*context), nullptr, std::move(*device)}, device.diagnostics()};
}

Result<OpenDevice> openFirst(const GlDeviceOptions& options)
{
    Result<OpenDevice> egl = openNamed("egl", options);
    if (egl) return egl;
    Diagnostics both = egl.diagnostics();
    Result<OpenDevice> osmesa = openNamed("osmesa", options);
    append(both, osmesa.diagnostics());
    if (!osmesa) return both;
    Diagnostics warnings = osmesa.diagnostics();
    warnings.push_back(
        asWarning({Code::no_egl,
                   "EGL cannot be used (" + both.front().message + "); drawing with OSMesa instead",
                   "write --backend osmesa to choose it without this warning"}));
    return {std::move(*osmesa), std::move(warnings)};
}

}  // namespace

void addBackendOption(CLI::App& app, std::string& backend)
{
    addText(app, "--backend", backend, "BACKEND",
            "egl or osmesa; default: EGL, and OSMesa where there is no EGL")
        ->check(CLI::IsMember({"egl", "osmesa"}));
}

void addPrecisionOption(CLI::App& app, std::string& precision)
{
    addText(app, "--precision", precision, "PRECISION",
            "Precision of mediump in shaders: full (32 bits) or half (16 bits, as on "
            "phones). Default: the driver's")
        ->check(CLI::IsMember({"full", "half"}));
}

void addProgramCacheOption(CLI::App& app, std::string& folder)
{
    addText(app, "--program-cache", folder, "FOLDER",
            "Folder that keeps linked programs, so that the next run compiles none of them. "
            "Default: none");
}

Result<OpenDevice> openDevice(const std::string& backend, const std::string& precision,
                              const std::string& program_folder)
{
    GlDeviceOptions options;
    std::unique_ptr<ProgramFolder> programs;
    if (!program_folder.empty()) {
        Result<std::unique_ptr<ProgramFolder>> folder = ProgramFolder::open(program_folder);
        if (!folder) return folder.diagnostics();
        programs = std::move(*folder);
        options.program_cache = programs->cache();
    }
    Result<OpenDevice> open = backend.empty() ? openFirst(options) : openNamed(backend, options);
    if (open) open->programs = std::move(programs);
    if (!open || precision.empty()) return open;
    const Mediump mediump = precision == "half" ? Mediump::half : Mediump::full;
    Result<std::unique_ptr<Device>> device = makeMediumpDevice(std::move(open->device), mediump);
    if (!device) return device.diagnostics();
    open->device = std::move(*device);
    return open;
}

}  // namespace crevice
