// SPDX-License-Identifier: MIT
// A host's locale changes no pixel: shaders are assembled and pictures drawn while it is in force.
#include "tests/support/catch.h"

#include "tests/backends/stage.h"
#include "tests/support/comma_locale.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

TEST_CASE("Shipped configs draw the same bits under a locale with a decimal comma")
{
    GlFixture gl;
    const Stage stage(*gl.device);
    const std::vector<Subject> subjects = sampledSubjects();
    const auto draw = [&stage](const Subject& subject) {
        return stage.draw(*stage.make(descriptionOf(subject)));
    };
    std::vector<Pixels> ordinary;
    for (const Subject& subject : subjects) ordinary.push_back(draw(subject));
    const auto locale = commaLocale();
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        INFO(subjects[i].config);
        CHECK((draw(subjects[i]) == ordinary[i]));
    }
}
