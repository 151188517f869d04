// SPDX-License-Identifier: MIT
// What --variant and --set made of a config, as a config of its own: `crevice render --save-patch`.
#pragma once

#include "tools/commands/cli/config_options.h"

namespace crevice {

/// Checks what can be known before drawing. Errors: CV8001 where `file` is the config or does not
/// end in .json, CV7007 where it cannot be written.
Status checkPatchFile(const ConfigOptions& options, const std::string& file);

/// Writes a config that extends the options' config and has, beyond it, the smallest patch with
/// which it loads as the config does with the options' variant and overrides. Errors: those of
/// loadConfig, CV7007.
Status savePatch(const ConfigOptions& options, const SourceSet& sources, const std::string& file);

}  // namespace crevice
