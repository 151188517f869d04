// SPDX-License-Identifier: MIT
// Images on disk: what is written is read back, and a failure leaves nothing behind.
#include "tools/image/image_file.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <limits>

using namespace crevice;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

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

TEST_CASE("a PNG gives back what was written, for 1, 3 and 4 channels")
{
    const TemporaryFolder folder("image_png");
    const std::string path = (folder.path / "a.png").string();
    for (const int channels : {1, 3, 4}) {
        const Image image = gradient({5, 3}, channels);
        REQUIRE(writePng(path, image).ok());
        const auto read = readImage(path);
        REQUIRE(read.ok());
        CHECK(read->extent == image.extent);
        CHECK(read->channels == channels);
        CHECK(read->pixels == image.pixels);
    }
}

TEST_CASE("a PNG of two channels is red and green")
{
    const TemporaryFolder folder("image_two");
    const std::string path = (folder.path / "a.png").string();
    REQUIRE(writePng(path, Image({2, 2}, 2, 1.0f)).ok());
    const auto read = readImage(path);
    REQUIRE(read.ok());
    CHECK(read->channels == 3);
    CHECK(read->at(1, 1, 1) == 1.0f);
    CHECK(read->at(1, 1, 2) == 0.0f);
}

TEST_CASE("a PNG clamps, and warns of what is not a number")
{
    const TemporaryFolder folder("image_clamp");
    const std::string path = (folder.path / "a.png").string();
    Image image({4, 1}, 1);
    image.pixels = {-3.0f, 7.0f, std::numeric_limits<float>::infinity(), 0.5f};
    const Status clamped = writePng(path, image);
    CHECK(clamped.ok());
    CHECK(clamped.diagnostics().empty());
    CHECK(readImage(path)->pixels == std::vector<float>{0.0f, 1.0f, 1.0f, 128 / 255.0f});
    image.pixels[3] = kNan;
    const Status warned = writePng(path, image);
    CHECK(warned.ok());
    REQUIRE(warned.diagnostics().size() == 1);
    CHECK(warned.diagnostics()[0].code == Code::not_finite);
    CHECK(readImage(path)->pixels[3] == 0.0f);
}

TEST_CASE("a PFM keeps every bit, also of what is not a number")
{
    const TemporaryFolder folder("image_pfm");
    const std::string path = (folder.path / "a.pfm").string();
    Image image({3, 2}, 1);
    const float infinity = std::numeric_limits<float>::infinity();
    image.pixels = {1e-30f, -0.0f, 3.14159274f, infinity, 65504.0f, kNan};
    REQUIRE(writePfm(path, image).ok());
    const auto read = readImage(path);
    REQUIRE(read.ok());
    CHECK(read->extent == image.extent);
    for (std::size_t k = 0; k < 5; ++k) CHECK(read->pixels[k] == image.pixels[k]);
    CHECK(std::isnan(read->pixels[5]));
    REQUIRE(writePfm(path, gradient({3, 2}, 4)).ok());
    CHECK(readImage(path)->channels == 3);
}

TEST_CASE("a PFM of either byte order is read, the bottom row first")
{
    const TemporaryFolder folder("image_order");
    const std::string low(" \0\0\x80\x3f\0\0\0\x40", 9), high(" \x3f\x80\0\0\x40\0\0\0", 9);
    const auto little = readImage(folder.write("little.pfm", "Pf 1 2 -1.0" + low));
    const auto big = readImage(folder.write("big.pfm", "Pf\n1 2\n1.0" + high));
    REQUIRE(little.ok());
    REQUIRE(big.ok());
    CHECK(little->at(0, 0) == 1.0f);
    CHECK(little->at(0, 1) == 2.0f);
    CHECK(big->pixels == little->pixels);
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
    CHECK(codeOf(writePng((folder.path / "taken.png").string(), image)) == Code::cannot_write);
    CHECK(codeOf(writePfm((folder.path / "none" / "a.pfm").string(), image)) == Code::cannot_write);
    CHECK(codeOf(writePng("/dev/full", image)) == Code::cannot_write);
    CHECK(filesIn(folder.path) == 1);
    const Status status = writePfm((folder.path / "none" / "a.pfm").string(), image);
    CHECK(status.diagnostics()[0].message.find("No such file") != std::string::npos);
}

TEST_CASE("a write replaces the file, through a link too, and leaves no other")
{
    const TemporaryFolder folder("image_replace");
    const std::string file = folder.write("real.pfm", "old");
    const auto link = folder.path / "link.pfm";
    std::filesystem::create_symlink(file, link);
    REQUIRE(writePfm(link.string(), gradient({2, 2}, 1)).ok());
    CHECK(std::filesystem::is_symlink(link));
    CHECK(readImage(file).ok());
    CHECK(filesIn(folder.path) == 2);
}

TEST_CASE("an image without pixels is not written")
{
    const TemporaryFolder folder("image_none");
    const std::string path = (folder.path / "a.png").string();
    CHECK(codeOf(writePng(path, Image())) == Code::image_broken);
    CHECK(codeOf(writePfm(path, Image({0, 4}, 1))) == Code::image_broken);
    CHECK(filesIn(folder.path) == 0);
}

TEST_CASE("the extension says what is written")
{
    const TemporaryFolder folder("image_extension");
    const Image image = gradient({2, 2}, 1);
    CHECK(writeImage((folder.path / "a.PNG").string(), image).ok());
    CHECK(writeImage((folder.path / "a.pfm").string(), image).ok());
    CHECK(codeOf(writeImage((folder.path / "a.exr").string(), image)) == Code::usage);
    CHECK(codeOf(writeImage((folder.path / "a").string(), image)) == Code::usage);
    CHECK(filesIn(folder.path) == 2);
}

TEST_CASE("a stale temporary file of the same process id is in nobody's way")
{
    const TemporaryFolder folder("image_stale");
    const std::string path = (folder.path / "a.pfm").string();
    for (int i = 0; i < 500; ++i)
        folder.write(".crevice-" + std::to_string(getpid()) + "-" + std::to_string(i) + ".tmp",
                     "stale");
    folder.write("a.pfm." + std::to_string(getpid()) + ".tmp", "stale");
    CHECK(writeFile(path, "bytes").ok());
    CHECK(readFile(path)->text == "bytes");
    CHECK(filesIn(folder.path) == 502);
}

TEST_CASE("a name as long as names can be is written")
{
    const TemporaryFolder folder("image_long");
    const std::string path = (folder.path / (std::string(251, 'a') + ".png")).string();
    CHECK(writePng(path, gradient({2, 2}, 1)).ok());
    CHECK(filesIn(folder.path) == 1);
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
    CHECK_THAT(unpacked.diagnostics()[0].message, Catch::Contains("more than are read"));
}
