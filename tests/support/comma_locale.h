// SPDX-License-Identifier: MIT
// The locale that Qt and GTK programs run in on a German desktop, for C and C++: 1.234,5 is a
// number.
#pragma once

#include "tests/support/temporary_folder.h"

#include <clocale>
#include <cstdlib>
#include <locale>
#include <memory>

namespace crevice {

/// The global locale of C and C++ while this lives. Debian's package `locales` makes it; `made()`
/// is false where that is missing.
class CommaLocale {
public:
    CommaLocale()
    {
        const std::string name = "de_DE.UTF-8";
        const std::string path = (folder_.path / name).string();
        const std::string make = "localedef -i de_DE -f UTF-8 " + path + " > /dev/null 2>&1";
        if (std::system(make.c_str()) != 0) return;
        setenv("LOCPATH", folder_.path.c_str(), 1);
        made_ = std::setlocale(LC_ALL, name.c_str()) != nullptr;
        if (made_) std::locale::global(std::locale(name.c_str()));
    }
    ~CommaLocale()
    {
        std::locale::global(std::locale::classic());
        unsetenv("LOCPATH");
    }

    bool made() const { return made_; }

private:
    TemporaryFolder folder_{"locale"};
    bool made_ = false;
};

/// A comma locale, or a failed test.
inline std::unique_ptr<CommaLocale> commaLocale()
{
    auto locale = std::make_unique<CommaLocale>();
    INFO("the package 'locales' is missing");
    REQUIRE(locale->made());
    return locale;
}

}  // namespace crevice
