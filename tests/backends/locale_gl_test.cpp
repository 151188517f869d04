// SPDX-License-Identifier: MIT
// A host's locale changes no pixel: shaders are assembled and pictures drawn while it is in force.
#include "tests/support/catch.h"

#include "tests/support/comma_locale.h"
#include "tests/support/picture.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

using namespace crevice;

namespace {

Image drawn(const std::string& config)
{
    PictureRequest request;
    request.config = config;
    request.extent = {48, 27};
    return picture(request);
}

}  // namespace

TEST_CASE("Every shipped config draws the same bits under a locale with a decimal comma")
{
    const std::vector<std::string> names = configNames(shippedSources());
    std::vector<Image> ordinary;
    for (const std::string& name : names) ordinary.push_back(drawn(name));
    const auto locale = commaLocale();
    for (std::size_t i = 0; i < names.size(); ++i) {
        INFO(names[i]);
        CHECK((drawn(names[i]).pixels == ordinary[i].pixels));
    }
}
