// SPDX-License-Identifier: MIT
// The keys of matrix files, as tables that the reader goes by.
#pragma once

#include "tools/measure/matrix/matrix.h"
#include "tools/measure/reference/tracer.h"

#include <cmath>

namespace crevice {

/// The keys of axes, by MatrixAxisIndex; `fallback` is the one value where the file leaves them
/// out, null where it must not.
inline constexpr struct MatrixAxisKey {
    const char* key;
    const char* axis;
    const char* fallback;
} kAxisKeys[] = {{"configs", "config", nullptr}, {"variants", "variant", ""},
                 {"scenes", "scene", nullptr},   {"cameras", "camera", ""},
                 {"sizes", "size", "320x180"},   {"backends", "backend", "egl"}};

inline const std::vector<std::string> kOtherKeys = {"format",          "$schema",        "params",
                                                    "combine",         "cells",          "checks",
                                                    "approved_folder", "approved_format"};

constexpr double kNoLimit = INFINITY;

struct CheckNumberKey {
    const char* name;
    double least, most;
    double value;  ///< Without it: NaN where it must be there, kNoLimit where nothing is then set.
    bool whole = false;
};

inline const CheckNumberKey kShare = {"share", 0, 1, 0},
                            kRays = {"rays", 1, kMaxTraceRays, 64, true};

/// The kinds of checks by CheckKind, and the numbers in each.
inline const struct CheckKindKey {
    const char* name;
    std::vector<CheckNumberKey> numbers;  ///< None: the value is `true`.
    const char* help;
    const char* other = nullptr;  ///< The key that names another cell.
    bool bare = false;            ///< The numbers stand alone, several in a list.
} kKinds[] = {
    {"approved",
     {{"max", 0, 1, kNoLimit}, kShare, {"flip", 0, 1, kNoLimit}},
     "write {\"approved\": {\"max\": 0.01, \"share\": 0.001}} or {\"approved\": {\"flip\": 0.02}}"},
    {"truth",
     {{"rmse", 0, 1, kNoLimit}, {"bias", 0, 1, kNoLimit}, kRays},
     "write {\"truth\": {\"rmse\": 0.08, \"bias\": 0.02}}"},
    {"same",
     {{"max", 0, 1, 0}, kShare},
     "write {\"same\": {\"as\": {\"backend\": \"egl\"}, \"max\": 0.01}}",
     "as"},
    {"plan", {}, "write {\"plan\": true}"},
    {"time",
     {{"most", 0, 1e6, NAN}},
     "write {\"time\": {\"over\": {\"config\": \"learnopengl\"}, \"most\": 1.5}}",
     "over"},
    {"finite", {}, "write {\"finite\": true}"},
    {"range",
     {{"low", -1e30, 1e30, NAN}, {"high", -1e30, 1e30, NAN}},
     "write {\"range\": [0, 1]}",
     nullptr,
     true},
    {"background", {{"value", -1e30, 1e30, NAN}}, "write {\"background\": 1}", nullptr, true},
    {"open",
     {{"least", 0, 1, NAN}, kShare, kRays},
     "write {\"open\": {\"least\": 0.9, \"share\": 0.01}}"}};

inline std::vector<std::string> topKeys()
{
    std::vector<std::string> keys = kOtherKeys;
    for (const MatrixAxisKey& each : kAxisKeys) keys.push_back(each.key);
    return keys;
}

/// The kinds, and then what any check may have.
inline std::vector<std::string> checkKeys(bool kinds_only)
{
    std::vector<std::string> keys = namesOf(kKinds);
    if (!kinds_only) keys.insert(keys.end(), {"where", "output"});
    return keys;
}

inline std::vector<std::string> keysOf(const CheckKindKey& kind)
{
    std::vector<std::string> keys = namesOf(kind.numbers);
    if (kind.other) keys.push_back(kind.other);
    return keys;
}

/// All that there are, for the test of the documentation.
inline std::vector<std::string> matrixKeys()
{
    std::vector<std::string> all = topKeys();
    const auto add = [&](const std::vector<std::string>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    add(checkKeys(false));
    for (const CheckKindKey& kind : kKinds)
        if (!kind.bare) add(keysOf(kind));
    return all;
}

}  // namespace crevice
