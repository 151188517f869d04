// SPDX-License-Identifier: MIT
// Images on disk: what is written is read back, and a failure leaves nothing behind.
// The figures between two images, on images whose figures are known.
#include "tools/render/image/image_file.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/render/image/image_metrics.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <cmath>
#include <limits>

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

// Values spread over (0, 1].
Image ramp(int count, double power = 1.0)
{
    Image image({count, 1}, 1);
    for (int x = 0; x < count; ++x)
        image.at(x, 0) = static_cast<float>(std::pow((x + 1.0) / count, power));
    return image;
}

ImageDifference compare(const Image& test, const Image& ground_truth, const Image* mask = nullptr)
{
    return need(compareImages(test, ground_truth, mask));
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

TEST_CASE("PFM and EXR keep every bit, also of what is not a number")
{
    const TemporaryFolder folder("image_floats");
    for (const auto& [name, channels] : {std::pair("a.pfm", 3), {"a.exr", 4}}) {
        const std::string path = (folder.path / name).string();
        Image image({3, 2}, 1);
        image.pixels = {1e-30f, -0.0f, 3.14159274f, kInfinity, 65504.0f, kNan};
        REQUIRE(writeImage(path, image).ok());
        const Image read = need(readImage(path));
        CHECK(read.extent == image.extent);
        CHECK(std::memcmp(read.pixels.data(), image.pixels.data(), 6 * sizeof(float)) == 0);
        const Image colors = gradient({3, 2}, 4);
        REQUIRE(writeImage(path, colors).ok());
        const Image back = need(readImage(path));
        REQUIRE(back.channels == channels);
        for (int channel = 0; channel < channels; ++channel)
            CHECK(back.at(2, 1, channel) == colors.at(2, 1, channel));
    }
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
        CHECK(has(onlyError(readImage(path), Code::image_broken).message, path));
    }
}

TEST_CASE("a write that fails says why and leaves nothing behind")
{
    const TemporaryFolder folder("image_fail");
    std::filesystem::create_directories(folder.path / "taken.png");
    const Image image = gradient({4, 4}, 1);
    const auto in = [&](const char* name) { return (folder.path / name).string(); };
    onlyError(writePng(in("taken.png"), image), Code::cannot_write);
    onlyError(writePng("/dev/full", image), Code::cannot_write);
    const Status status = writePfm(in("none/a.pfm"), image);
    CHECK(has(onlyError(status, Code::cannot_write).message, "No such file"));
    onlyError(writePng(in("a.png"), Image()), Code::image_broken);  // without pixels
    onlyError(writePfm(in("a.pfm"), Image({0, 4}, 1)), Code::image_broken);
    onlyError(writeImage(in("a.tif"), image), Code::usage);  // the extension says what
    onlyError(writeImage(in("a"), image), Code::usage);
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
    for (const char* link : {"nowhere", "loop"})
        CHECK(has(onlyError(writeFile(in(link), "text"), Code::cannot_write).message, link));
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
        onlyError(readImage(path), Code::image_broken);
    CHECK(peakMemory() - before < 64 * 1024);
    // 16384x16384 pixels in a header: the picture itself could be a few thousand bytes.
    const std::string bomb(
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0\0\0\0\0", 33);
    CHECK(has(onlyError(decodeImage(bomb, "bomb"), Code::image_broken).message, "more than the"));
}

TEST_CASE("a constant error is rmse and bias alike")
{
    const ImageDifference figures = compare(Image({8, 8}, 1, 0.7f), Image({8, 8}, 1, 0.8f));
    CHECK(figures.rmse == Approx(0.1));
    CHECK(figures.bias == Approx(-0.1));
    CHECK(figures.p99 == Approx(0.1));
    CHECK(figures.max == Approx(0.1));
    CHECK(figures.psnr_db == Approx(20));
    CHECK(figures.bad_fraction == 1);
}

TEST_CASE("the 99th percentile passes over one pixel in a hundred")
{
    Image test = ramp(200);
    test.at(17, 0) += 0.5f;
    const ImageDifference figures = compare(test, ramp(200));
    CHECK(figures.p99 == 0);
    CHECK(figures.max == Approx(0.5));
    CHECK(figures.rmse == Approx(0.5 / std::sqrt(200.0)));
    CHECK(figures.bad_fraction == Approx(0.005));

    test = ramp(100);
    test.at(17, 0) += 0.5f;
    CHECK(compare(test, ramp(100)).p99 == 0);
    test.at(80, 0) += 0.25f;
    CHECK(compare(test, ramp(100)).p99 == Approx(0.25));
}

TEST_CASE("the pattern is what of an error repeats every few pixels, and no other")
{
    const auto patternOf = [](auto error) {
        Image test({64, 48}, 1, 0.5f);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) test.at(x, y) += 0.1f * error(x, y);
        return compare(test, Image({64, 48}, 1, 0.5f)).pattern;
    };
    CHECK(patternOf([](int, int) { return 1; }) < 1e-6);
    CHECK(patternOf([](int x, int y) { return (x + y) % 2 ? 1 : -1; }) < 0.02);
    CHECK(patternOf([](int x, int) { return x / 64.0; }) < 0.01);
    CHECK(patternOf([](int x, int) { return x % 6 < 3 ? 1 : -1; }) > 0.06);
    CHECK(patternOf([](int x, int y) { return (x / 4 + y / 4) % 2 ? 1 : -1; }) > 0.05);
}

TEST_CASE("the fit finds the power that was applied, and is never worse than none")
{
    for (const double power : {0.2, 0.5, 1.8, 5.0}) {
        const ImageDifference figures = compare(ramp(500), ramp(500, power));
        CHECK(figures.power_fit == Approx(power).epsilon(1e-3));
        CHECK(figures.rmse_fit < 1e-4);
        CHECK(figures.rmse > 0.05);
    }
    const Image one({4, 4}, 1, 1.0f);  // to any power
    const ImageDifference figures = compare(one, Image({4, 4}, 1, 0.25f));
    CHECK(figures.rmse_fit == Approx(figures.rmse));
    CHECK(figures.power_fit == 1);
}

TEST_CASE("only pixels with a ground truth, a finite value and no mask of zero count")
{
    Image ground_truth = ramp(10), test = ramp(10), mask({10, 1}, 1, 1.0f);
    ground_truth.at(0, 0) = test.at(0, 0) = kNan;
    mask.at(1, 0) = 0;
    test.at(1, 0) = 99;
    const ImageDifference masked = compare(test, ground_truth, &mask);
    CHECK(masked.rmse == 0);
    CHECK(masked.pixels == 8);
    CHECK(masked.masked == 2);
    CHECK(masked.non_finite == 0);
    test = ramp(10);
    test.at(3, 0) = kNan;
    test.at(4, 0) = std::numeric_limits<float>::infinity();
    const ImageDifference broken = compare(test, ramp(10));
    CHECK(broken.non_finite == 2);
    CHECK(broken.pixels == 8);
    CHECK(broken.rmse == 0);
    const ImageDifference nothing = compare(ramp(3), Image({3, 1}, 1, kNan));
    CHECK(nothing.rmse == 0);
    CHECK(nothing.pixels == 0);
    CHECK(nothing.masked == 3);
}

TEST_CASE("the difference picture is blue where darker, red where brighter, white where equal")
{
    Image ground_truth({5, 1}, 1, 0.5f), test = ground_truth;
    test.at(1, 0) = 0.0f;
    test.at(2, 0) = 1.0f;
    test.at(3, 0) = kNan;
    ground_truth.at(4, 0) = kNan;
    const Image picture = need(differencePicture(test, ground_truth));
    REQUIRE(picture.channels == 3);
    CHECK(picture.pixels ==
          std::vector<float>{1, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0.5f, 0.5f, 0.5f});
}
