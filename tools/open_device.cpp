// SPDX-License-Identifier: MIT
// Choosing a context and making the device in it.
#include "tools/open_device.h"

#include "backends/gl_device.h"
#include "tools/mediump_device.h"

#include <CLI/CLI.hpp>

namespace crevice {
namespace {

Result<OpenDevice> makeDevice(std::unique_ptr<Context> context)
{
    Result<std::unique_ptr<Device>> device = makeGlDevice(context->loader());
    if (!device) return device.diagnostics();
    Diagnostics warnings = device.diagnostics();
    return {OpenDevice{std::move(context), std::move(*device)}, std::move(warnings)};
}

Result<OpenDevice> openNamed(std::string_view backend)
{
    Result<std::unique_ptr<Context>> context = makeContext(backend);
    if (!context) return context.diagnostics();
    return makeDevice(std::move(*context));
}

/// Both failed: EGL's error, with OSMesa's after it.
Diagnostics neither(const Diagnostics& egl, const Diagnostics& osmesa)
{
    Diagnostics errors = egl;
    errors.insert(errors.end(), osmesa.begin(), osmesa.end());
    return errors;
}

Result<OpenDevice> openFirst()
{
    Result<OpenDevice> egl = openNamed("egl");
    if (egl) return egl;
    Result<OpenDevice> osmesa = openNamed("osmesa");
    if (!osmesa) return neither(egl.diagnostics(), osmesa.diagnostics());
    Diagnostic warning{Code::no_egl, "EGL cannot be used (" + egl.diagnostics().front().message +
                                         "); drawing with OSMesa instead"};
    warning.severity = Severity::warning;
    warning.help = "--backend osmesa asks for it without this warning";
    Diagnostics warnings = osmesa.diagnostics();
    warnings.push_back(std::move(warning));
    return {std::move(*osmesa), std::move(warnings)};
}

}  // namespace

void addBackendOption(CLI::App& app, std::string& backend)
{
    app.add_option("--backend", backend,
                   "egl or osmesa; default: EGL, and OSMesa where there is no EGL")
        ->type_name("BACKEND")
        ->check(CLI::IsMember({"egl", "osmesa"}));
}

void addPrecisionOption(CLI::App& app, std::string& precision)
{
    app.add_option("--precision", precision,
                   "What mediump is in shaders: full, 32 bits; half, 16 bits as on phones; default: what the "
                   "driver makes of it")
        ->type_name("PRECISION")
        ->check(CLI::IsMember({"full", "half"}));
}

Result<OpenDevice> openDevice(const std::string& backend, const std::string& precision)
{
    Result<OpenDevice> open = backend.empty() ? openFirst() : openNamed(backend);
    if (!open || precision.empty()) return open;
    const Mediump mediump = precision == "half" ? Mediump::half : Mediump::full;
    Result<std::unique_ptr<Device>> device = makeMediumpDevice(std::move(open->device), mediump);
    if (!device) return device.diagnostics();
    open->device = std::move(*device);
    return open;
}

}  // namespace crevice
