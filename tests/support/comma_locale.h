// SPDX-License-Identifier: MIT
// The locale that Qt and GTK programs run in on a German desktop, for C and C++: 1.234,5 is a
// number.
#pragma once

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <clocale>
#include <cstdlib>
#include <locale>

namespace crevice {

/// The global locale of C and C++ while this lives. Debian's package `locales` makes it; the test
/// fails where that is missing.
class CommaLocale {
public:
    CommaLocale()
    {
        const std::string path = (folder_.path / "de_DE.UTF-8").string();
        const std::string make = "localedef -i de_DE -f UTF-8 " + path + " > /dev/null 2>&1";
        INFO("the package 'locales' is missing");
        REQUIRE(std::system(make.c_str()) == 0);
        setenv("LOCPATH", folder_.path.c_str(), 1);
        REQUIRE(std::setlocale(LC_ALL, "de_DE.UTF-8"));
        std::locale::global(std::locale("de_DE.UTF-8"));
    }
    ~CommaLocale()
    {
        std::locale::global(std::locale::classic());
        unsetenv("LOCPATH");
    }

private:
    TemporaryFolder folder_{"locale"};
};

inline CommaLocale commaLocale() { return CommaLocale(); }

}  // namespace crevice
