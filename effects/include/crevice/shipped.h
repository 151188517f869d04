// SPDX-License-Identifier: MIT
// The shipped modules and configs, embedded in the library at build time.
#pragma once

#include <crevice/source.h>

namespace crevice {

/// All of effects/ by path ("ssao/hemisphere.json", "ssao/shaders/hemisphere.frag") and all of
/// configs/ and its folders under "configs/" ("configs/learnopengl.json", whose file is
/// configs/ports/learnopengl.json). To edit one while a program runs, layer
/// MemorySources with your text of it over this set.
const SourceSet& shippedSources();

/// The shipped modules and configs, and one's own: those below effects/ and configs/ of a folder
/// hide shipped ones of the same name. FOLDER/effects/ssao/mine.json is the module "ssao/mine".
/// Files are read again at each `find`. What the commands read with --effects.
class CheckoutSources : public SourceSet {
public:
    /// `folder` empty: only what is shipped. Links in it lead to what is below it or below `roots`.
    explicit CheckoutSources(std::string folder, std::vector<std::string> roots = {});

    SourceRef find(std::string_view path) const override;
    std::vector<std::string> list() const override;

private:
    std::string fileOf(std::string_view name) const;

    bool used_;
    DirectorySources effects_;
    DirectorySources configs_;
};

}  // namespace crevice
