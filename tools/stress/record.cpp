// SPDX-License-Identifier: MIT
// Stress records as JSON Lines. The keys are the fields' names.
#include "tools/stress/record.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/measure/line_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <unordered_map>

namespace crevice {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StressRecord, key, config, variant, overrides, case_name, format,
                                   step, label, value, device, version, refusal, absent, bad_target,
                                   bad_pass, bad_pixels, out_of_range, mean, least, most, stored,
                                   step_share, resolved, judged, judged_mean, judged_least,
                                   judged_below, change, rmse, radius_px, ms, picture)

namespace {

Diagnostic brokenLine(const std::string& path, int number, const std::string& reason)
{
    Diagnostic error{Code::results_broken, "'" + path + "', line " + std::to_string(number) +
                                               ": this is no step of a stress case: " + reason};
    error.help = "delete the line; 'crevice stress' measures its step again";
    return error;
}

}  // namespace

std::string toJsonLine(const StressRecord& record)
{
    const nlohmann::json json = record;
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<std::vector<StressRecord>> readStressRecords(const std::string& path)
{
    std::vector<StressRecord> records;
    std::unordered_map<std::string, std::size_t> places;
    FileBytes file = readBytes(path, kMaxResultBytes);
    if (!file) {
        Diagnostic error{Code::results_broken,
                         "no results can be read from '" + path + "': " + file.failure};
        error.help = "'crevice stress' writes them: crevice stress --help";
        return error;
    }
    int number = 0;
    for (const std::string_view line : split(file.bytes, '\n')) {
        ++number;
        if (line.empty()) continue;
        try {
            StressRecord record = nlohmann::json::parse(line).get<StressRecord>();
            const auto [place, is_new] = places.emplace(record.key, records.size());
            if (is_new) records.push_back(std::move(record));
            else records[place->second] = std::move(record);
        } catch (const nlohmann::json::exception& error) {
            return brokenLine(path, number, error.what());
        }
    }
    return records;
}

}  // namespace crevice
