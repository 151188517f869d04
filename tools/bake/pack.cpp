// SPDX-License-Identifier: MIT
// Packing, and bytes as C.
#include "core/bake/pack.h"

#include "core/bake/archive.h"
#include "tools/bake/bake.h"

#include <unordered_map>

namespace crevice {
namespace {

constexpr std::size_t kLeastRepeat = 4;  ///< A shorter one takes as much as it saves.
constexpr int kMostTries = 256;          ///< Places that are compared with; more save a percent.

/// Where texts that begin like the one at a place stood before.
class Places {
public:
    explicit Places(std::string_view bytes) : bytes_(bytes), before_(bytes.size(), kNone) {}

    void add(std::size_t at)
    {
        if (at + kLeastRepeat > bytes_.size()) return;
        const auto [entry, is_new] = last_.try_emplace(keyAt(at), at);
        if (!is_new) before_[at] = std::exchange(entry->second, at);
    }

    struct Match {
        std::size_t at = 0, size = 0;
    };

    /// The longest that is followed as `at` is; the latest of those.
    Match longest(std::size_t at) const
    {
        Match best;
        if (at + kLeastRepeat > bytes_.size()) return best;
        const auto first = last_.find(keyAt(at));
        std::size_t other = first == last_.end() ? kNone : first->second;
        for (int tries = 0; other != kNone && tries < kMostTries; ++tries, other = before_[other]) {
            std::size_t size = 0;
            while (at + size < bytes_.size() && bytes_[other + size] == bytes_[at + size]) ++size;
            if (size > best.size) best = {other, size};
        }
        return best;
    }

private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    std::uint32_t keyAt(std::size_t at) const
    {
        std::uint32_t key = 0;
        std::memcpy(&key, &bytes_[at], sizeof key);
        return key;
    }

    std::string_view bytes_;
    std::vector<std::size_t> before_;
    std::unordered_map<std::uint32_t, std::size_t> last_;
};

/// What naming a repeat saves.
std::ptrdiff_t savedBy(const Places::Match& match, std::size_t at)
{
    const std::size_t back = at - match.at;
    const std::ptrdiff_t takes = 2 + (back < 128 ? 1 : back < 16384 ? 2 : 3);
    return static_cast<std::ptrdiff_t>(match.size) - takes;
}

}  // namespace

std::string pack(std::string_view bytes)
{
    ArchiveWriter packed;
    Places places(bytes);
    std::size_t begin = 0;
    for (std::size_t at = 0; at < bytes.size();) {
        const Places::Match match = places.longest(at);
        places.add(at);
        // A longer repeat from the next byte on is worth this one as it is.
        const bool later = savedBy(places.longest(at + 1), at + 1) > savedBy(match, at);
        if (match.size < kLeastRepeat || savedBy(match, at) <= 0 || later) {
            ++at;
            continue;
        }
        packed.member(std::string(bytes.substr(begin, at - begin)));
        packed.number(static_cast<std::uint32_t>(match.size));
        packed.number(static_cast<std::uint32_t>(at - match.at));
        for (std::size_t i = 1; i < match.size; ++i) places.add(at + i);
        at += match.size;
        begin = at;
    }
    if (begin < bytes.size()) packed.member(std::string(bytes.substr(begin)));
    return packed.bytes;
}

std::string asHeader(std::string_view bytes, const std::string& name)
{
    std::string text =
        "/* Written by crevice bake. */\n#include <stddef.h>\n\nstatic const unsigned "
        "char " +
        name + "[] = {";
    for (std::size_t i = 0; i < bytes.size(); ++i)
        text += (i % 20 == 0 ? "\n    " : "") +
                std::to_string(static_cast<unsigned char>(bytes[i])) + ",";
    return text + "\n};\nstatic const size_t " + name + "_size = sizeof " + name + ";\n";
}

}  // namespace crevice
