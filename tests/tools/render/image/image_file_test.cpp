// SPDX-License-Identifier: MIT
// Images on disk: what is written is read back, and a failure leaves nothing behind.
#include "tools/render/image/image_file.h"

#include "core/base/files.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <cstring>
#include <tuple>

using namespace crevice;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Every pixel and channel another value, exact in eight bits.
Image gradient(Extent extent, int channels)
{
    Image image(extent, channels);
    for (std::size_t k = 0; k < image.pixels.size(); ++k)
        image.pixels[k] = static_cast<float>(k * 7 % 256) / 255.0f;
    return image;
}

/// Most memory that the process has had, in KiB.
long peakMemory()
{
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

int filesIn(const std::filesystem::path& folder)
{
    int count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

template <class T>
Code codeOf(const T& result)
{
    REQUIRE_FALSE(result.ok());
    return result.diagnostics().front().code;
}

}  // namespace

TEST_CASE("a PNG gives back what was written; of two channels they are red and green")
{
    const TemporaryFolder folder("image_png");
    const std::string path = (folder.path / "a.png").string();
    for (const int channels : {1, 2, 3, 4}) {
        const Image image = gradient({5, 3}, channels);
        REQUIRE(writePng(path, image).ok());
        const Image read = need(readImage(path));
        CHECK(read.extent == image.extent);
        REQUIRE(read.channels == (channels == 2 ? 3 : channels));
        for (int k = 0; k < 5 * 3 * read.channels; ++k) {
            const int x = k / read.channels % 5, y = k / read.channels / 5, c = k % read.channels;
            CHECK(read.at(x, y, c) == (c < channels ? image.at(x, y, c) : 0.0f));
        }
    }
}

TEST_CASE("a PNG clamps, and warns of what is not a number")
{
    const TemporaryFolder folder("image_clamp");
    const std::string path = (folder.path / "a.png").string();
    Image image({4, 1}, 1);
    for (const auto& [last, written, warnings] :
         {std::tuple(0.5f, 128 / 255.0f, 0u), {kNan, 0.0f, 1u}}) {
        image.pixels = {-3.0f, 7.0f, kInfinity, last};
        const Status status = writePng(path, image);
        CHECK(status.ok());
        REQUIRE(status.diagnostics().size() == warnings);
        if (warnings > 0) CHECK(status.diagnostics()[0].code == Code::not_finite);
        CHECK(readImage(path)->pixels == std::vector<float>{0.0f, 1.0f, 1.0f, written});
    }
}

TEST_CASE("a PFM keeps every bit, also of what is not a number")
{
    const TemporaryFolder folder("image_pfm");
    const std::string path = (folder.path / "a.pfm").string();
    Image image({3, 2}, 1);
    image.pixels = {1e-30f, -0.0f, 3.14159274f, kInfinity, 65504.0f, kNan};
    REQUIRE(writePfm(path, image).ok());
    const Image read = need(readImage(path));
    CHECK(read.extent == image.extent);
    CHECK(std::memcmp(read.pixels.data(), image.pixels.data(), 6 * sizeof(float)) == 0);
    REQUIRE(writePfm(path, gradient({3, 2}, 4)).ok());
    CHECK(readImage(path)->channels == 3);
}

TEST_CASE("an image that cannot be read is reported with its name")
{
    const TemporaryFolder folder("image_broken");
    const std::string png = (folder.path / "whole.png").string();
    REQUIRE(writePng(png, gradient({40, 30}, 3)).ok());
    const std::string bytes = readFile(png)->text;
    const std::vector<std::string> paths = {
        folder.write("cut.png", bytes.substr(0, bytes.size() / 2)),
        folder.write("empty.png", ""),
        folder.write("noise.png", "not a picture at all"),
        folder.write("short.pfm", "Pf 100 100 -1.0 abcd"),
        folder.write("negative.pfm", "Pf -1 100 -1.0 abcd"),
        folder.write("huge.pfm", "PF 2000000000 2000000000 -1.0 abcd"),
        folder.write("words.pfm", "Pf wide high -1.0 abcd"),
        (folder.path / "missing.png").string(),
        folder.path.string(),
    };
    for (const std::string& path : paths) {
        INFO(path);
        const auto image = readImage(path);
        CHECK(codeOf(image) == Code::image_broken);
        CHECK(image.diagnostics()[0].message.find(path) != std::string::npos);
    }
}

TEST_CASE("a write that fails says why and leaves nothing behind")
{
    const TemporaryFolder folder("image_fail");
    std::filesystem::create_directories(folder.path / "taken.png");
    const Image image = gradient({4, 4}, 1);
    const auto in = [&](const char* name) { return (folder.path / name).string(); };
    CHECK(codeOf(writePng(in("taken.png"), image)) == Code::cannot_write);
    CHECK(codeOf(writePng("/dev/full", image)) == Code::cannot_write);
    const Status status = writePfm(in("none/a.pfm"), image);
    CHECK(codeOf(status) == Code::cannot_write);
    CHECK(status.diagnostics()[0].message.find("No such file") != std::string::npos);
    CHECK(codeOf(writePng(in("a.png"), Image())) == Code::image_broken);  // without pixels
    CHECK(codeOf(writePfm(in("a.pfm"), Image({0, 4}, 1))) == Code::image_broken);
    CHECK(codeOf(writeImage(in("a.exr"), image)) == Code::usage);  // the extension says what
    CHECK(codeOf(writeImage(in("a"), image)) == Code::usage);
    CHECK(filesIn(folder.path) == 1);
}

TEST_CASE("a write replaces the file, through a link too, under any name, and leaves no other")
{
    const TemporaryFolder folder("image_replace");
    const Image image = gradient({2, 2}, 1);
    const std::string file = folder.write("real.pfm", "old");
    const auto link = folder.path / "link.pfm";
    std::filesystem::create_symlink(file, link);
    REQUIRE(writePfm(link.string(), image).ok());
    CHECK(std::filesystem::is_symlink(link));
    CHECK(readImage(file).ok());
    const std::string longest = std::string(251, 'a') + ".PNG";
    for (const std::string& name : {std::string("a.PNG"), std::string("a.pfm"), longest})
        CHECK(writeImage((folder.path / name).string(), image).ok());
    CHECK(filesIn(folder.path) == 5);
}

TEST_CASE("a write keeps the mode of the file that it replaces, and a new one has the umask's")
{
    const TemporaryFolder folder("image_mode");
    const auto modeOf = [](const std::string& path) {
        struct stat info = {};
        REQUIRE(stat(path.c_str(), &info) == 0);
        return info.st_mode & 07777;
    };
    for (const mode_t mode : {0600, 0640, 0444, 0666, 0755}) {
        const std::string file = folder.write("old.txt", "old");
        REQUIRE(chmod(file.c_str(), mode) == 0);
        need(writeFile(file, "new"));
        CHECK(modeOf(file) == mode);
        std::filesystem::remove(file);
    }
    const std::string fresh = (folder.path / "new.txt").string();
    const mode_t before = umask(027);
    need(writeFile(fresh, "new"));
    umask(before);
    CHECK(modeOf(fresh) == 0640);
}

TEST_CASE("a write makes the file that links lead to, and replaces no link")
{
    const TemporaryFolder folder("image_dangling");
    const auto in = [&](const char* name) { return (folder.path / name).string(); };
    std::filesystem::create_directory(in("other"));
    const std::pair<std::string, const char*> links[] = {{"other/a.txt", "relative"},
                                                         {in("other/b.txt"), "absolute"},
                                                         {"relative", "chain"},
                                                         {"none/a.txt", "nowhere"},
                                                         {"loop", "loop"}};
    for (const auto& [target, link] : links) std::filesystem::create_symlink(target, in(link));
    for (const char* link : {"chain", "absolute"}) need(writeFile(in(link), link));
    CHECK(readBytes(in("other/a.txt"), 9).bytes == "chain");
    CHECK(readBytes(in("other/b.txt"), 9).bytes == "absolute");
    for (const char* link : {"nowhere", "loop"}) {
        const Status status = writeFile(in(link), "text");
        CHECK(codeOf(status) == Code::cannot_write);
        CHECK_THAT(status.diagnostics()[0].message, Catch::Contains(link));
    }
    for (const auto& each : links) CHECK(std::filesystem::is_symlink(in(each.second)));
    CHECK(filesIn(folder.path) == 6);
    CHECK(filesIn(in("other")) == 2);
}

TEST_CASE("an image that is no regular file or larger than memory is refused unread")
{
    const TemporaryFolder folder("image_endless");
    const std::string pipe = (folder.path / "pipe.pfm").string();
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const std::string sparse = folder.write("sparse.pfm", "PF 100000 100000 -1.0 ");
    std::filesystem::resize_file(sparse, std::uintmax_t(1) << 40);
    const long before = peakMemory();
    for (const std::string& path : {pipe, std::string("/dev/zero"), sparse})
        CHECK(codeOf(readImage(path)) == Code::image_broken);
    CHECK(peakMemory() - before < 64 * 1024);
    // 16384x16384 pixels in a header: the picture itself could be a few thousand bytes.
    const std::string bomb(
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0\0\0\0\0", 33);
    const auto unpacked = decodeImage(bomb, "bomb");
    REQUIRE_FALSE(unpacked.ok());
    CHECK_THAT(unpacked.diagnostics()[0].message, Catch::Contains("more than the"));
}
