// SPDX-License-Identifier: MIT
// Keeping pictures.
#include "tools/measure/stress/pictures.h"

#include "tools/render/image/image_file.h"

#include <filesystem>
#include <set>

namespace crevice {

std::string pictureOf(const StressRecord& record) { return "pictures/" + record.key + ".png"; }

std::string truthPictureOf(const StressRecord& record)
{
    return "pictures/" + record.key + "_truth.png";
}

Status keepPictures(const std::string& folder, const StressDrawing& done)
{
    std::error_code error;
    std::filesystem::create_directories(folder + "/pictures", error);
    if (error) return Diagnostic{Code::cannot_write, "cannot write '" + folder + "/pictures'"};
    if (!done.ground_truth.pixels.empty())
        if (Status kept = writePng(folder + "/" + truthPictureOf(done.record), done.ground_truth);
            !kept)
            return kept;
    return writePng(folder + "/" + pictureOf(done.record), done.ao);
}

MeasureJob pictureJob(const std::vector<StressTask>& tasks, const MeasureJob& steps,
                      const std::vector<BreakdownPoint>& points, const std::string& folder,
                      std::function<StressDrawing(const StressTask&)> measure)
{
    std::set<std::string> wanted;
    for (const BreakdownPoint& point : points)
        for (const StressRecord* record : {point.before, point.after})
            if (record && !std::filesystem::exists(folder + "/" + pictureOf(*record)))
                wanted.insert(record->key);
    MeasureJob job;
    std::vector<const StressTask*> chosen;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (wanted.count(steps.tasks[i].key) == 0) continue;
        job.tasks.push_back({steps.tasks[i].key, "the picture of " + steps.tasks[i].title, {}});
        chosen.push_back(&tasks[i]);
    }
    job.measure = [keys = job.tasks, chosen, folder,
                   measure = std::move(measure)](std::size_t task) -> Result<Measured> {
        StressDrawing done = measure(*chosen[task]);
        done.record.key = keys[task].key;
        if (done.ao.pixels.empty()) return Measured{"", "not drawn"};
        if (const Status kept = keepPictures(folder, done); !kept) return kept.diagnostics();
        return Measured{"", "kept"};
    };
    return job;
}

}  // namespace crevice
