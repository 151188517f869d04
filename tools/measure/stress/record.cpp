// SPDX-License-Identifier: MIT
// Stress records as JSON Lines. The keys are the fields' names.
#include "tools/measure/stress/record.h"

#include "tools/measure/line_file.h"

#include <nlohmann/json.hpp>

namespace crevice {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StressRecord, config, case_name, step, device, version, refusal,
                                   absent, bad_target, bad_pass, bad_pixels, out_of_range, bad_x,
                                   bad_y, bad_value, background, mean, least, most, stored,
                                   step_share, resolved, judged, judged_mean, judged_least,
                                   judged_below, change, exact, occlusion, rmse, rmse_white,
                                   departing_pass, radius_px, height_px, picture)

std::string toJsonLine(const StressRecord& record) { return jsonLine(record); }

}  // namespace crevice
