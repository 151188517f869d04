// SPDX-License-Identifier: MIT
// Any bytes as a baked effect, down to the calls of a recording device: as a file, whose checksum
// is made to fit; and as the records behind it, which the fuzzer need not pack.
#include <crevice/baked.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "core/bake/pack.h"
#include "core/bake/records.h"

#include <cstdlib>

using namespace crevice;

namespace {

void expect(bool holds)
{
    if (!holds) std::abort();
}

void draw(const std::string& bytes)
{
    const auto baked = readBaked(bytes.data(), bytes.size());
    if (!baked) return expect(hasErrors(baked.diagnostics()));
    for (const BakedConfig& each : *baked) {
        RecordingDevice device;
        const Frame frame;
        {
            auto renderer =
                Renderer::createPlanned(device, each.description, {{64, 36}}, traitsOf(frame));
            if (renderer) (void)(*renderer)->render(frame);
        }
        expect(device.misuse().empty() && device.live() == 0);
    }
}

template <class T>
void append(std::string& bytes, T value)
{
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string records(reinterpret_cast<const char*>(data), size);
    draw(records);
    if (isBaked(data, size) && size >= kHeaderBytes) {
        ContentHash content;
        content.addBytes(data + kHeaderBytes, size - kHeaderBytes);
        const std::uint64_t value = content.value();
        std::string sealed = records;
        std::memcpy(&sealed[kHeaderBytes - sizeof value], &value, sizeof value);
        return draw(sealed), 0;
    }
    ArchiveWriter packed;  // one step, of all the bytes as they are
    packed.member(records);
    ContentHash hash;
    hash.addBytes(packed.bytes.data(), packed.bytes.size());
    std::string bytes(kMagic, sizeof kMagic);
    append(bytes, static_cast<std::uint32_t>(size));
    append(bytes, vocabulary());
    append(bytes, hash.value());
    draw(bytes + packed.bytes);
    return 0;
}
