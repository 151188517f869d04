// SPDX-License-Identifier: MIT
// crevice choose: the best measured config for a time or an error, and why.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/bench/choice.h"
#include "tools/measure/bench/quick.h"
#include "tools/measure/bench/run.h"
#include "tools/render/device/open_device.h"
#include "tools/render/image/image_file.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/options.h"
#include "tools/show/plan/print.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace crevice {
namespace {

/// How many other configs are printed on either side of the limit.
constexpr std::size_t kOthersShown = 4;

struct ChooseOptions {
    std::vector<std::string> results;
    ConfigOptions config;  ///< What all configs have in common.
    std::vector<std::string> configs;
    SceneOptions scene;
    ChoiceScope scope;  ///< Of results.
    std::string budget;
    double error = 0;
    bool motion = false;
    std::string backend;
    RunOptions run;
    std::string write;
    std::string write_front;
    bool json = false;
};

/// A question that was answered.
struct Answer {
    std::vector<BenchSample> samples;
    Candidates candidates;
    ChoiceLimits limits;
    Choice choice;
    Diagnostics warnings;
    OpenDevice open = {};  ///< What comes later goes first.
    BenchView view = {};
    std::unique_ptr<QuickBench> quick = {};  ///< None where the samples are of earlier benches.

    const Candidate& best() const { return candidates.list[choice.within.front()]; }
    const BenchSample& bestSample() const { return samples[best().sample]; }
};

Result<ChoiceLimits> limitsOf(const ChooseOptions& options)
{
    ChoiceLimits limits;
    if (!options.budget.empty()) {
        const Result<ChoiceLimit> budget = parseBudget(options.budget);
        if (!budget) return budget.diagnostics();
        limits.push_back(*budget);
    }
    if (options.error > 0) limits.push_back({ChoiceLimit::Kind::error, options.error});
    const bool answers = options.write_front.empty() || !options.write.empty() || options.json;
    if (!limits.empty() || !answers) return limits;
    return Diagnostic{Code::usage, "crevice choose wants --budget, --error or both",
                      "write --budget 2ms for the most accurate config within a time, or "
                      "--error 0.06 for the fastest within an error"};
}

/// Measures in the scene. Errors: those of loadSceneView, openDevice and QuickBench::run.
Status measureScene(const ChooseOptions& options, const SourceSet& sources, Answer& answer)
{
    const Result<double> time = timeBudgetOf(options.run);
    if (!time) return time.diagnostics();
    Progress progress;
    progress.begin("loading the scene");
    Result<SceneView> view = loadSceneView(options.scene);
    if (!view) return view.diagnostics();
    append(answer.warnings, view.diagnostics());
    answer.view = {std::make_shared<Scene>(std::move(view->scene)), view->bounds, view->camera,
                   view->extent};
    Result<OpenDevice> open = openDevice(options.backend);
    if (!open) return open.diagnostics();
    answer.open = std::move(*open);
    QuickOptions quick{options.scene.scene,  options.configs, options.config.overrides,
                       options.config.roots, answer.limits,   !options.write_front.empty(),
                       options.motion};
    if (*time > 0) quick.time_s = *time;
    quick.version = CREVICE_VERSION;
    quick.interrupted = interrupted;
    quick.say = [&progress](const std::string& line) {
        progress.wipe();
        printMessage("%s\n", printableLine(line).c_str());
        progress.begin("measuring");
    };
    progress.begin("measuring");
    catchInterrupts();
    answer.quick =
        std::make_unique<QuickBench>(*answer.open.device, answer.view, sources, std::move(quick));
    const Status measured = answer.quick->run();
    if (!measured) return measured;
    append(answer.warnings, measured.diagnostics());
    answer.samples = answer.quick->samples();
    return {};
}

/// Reads what was measured. Errors: those of readBenchSamples and parseSize.
Status readResults(const ChooseOptions& options, ChoiceScope& scope, Answer& answer)
{
    if (!options.scene.size.empty()) {
        const Result<Extent> extent = parseSize(options.scene.size);
        if (!extent) return extent.diagnostics();
        scope.extent = *extent;
    }
    scope.scene = options.scene.scene;
    Result<std::vector<BenchSample>> samples = readBenchSamples(options.results);
    if (!samples) return samples.diagnostics();
    for (const BenchSample& each : *samples)
        if (options.motion && each.failure.empty() && each.motion.paths.empty())
            return Diagnostic{Code::usage, sampleTitle(each) + " has no flicker for --motion",
                              "measure it by crevice bench --motion"};
    append(answer.warnings, samples.diagnostics());
    answer.samples = std::move(*samples);
    return {};
}

Result<Answer> answerFor(const ChooseOptions& options, const SourceSet& sources)
{
    Answer answer;
    Result<ChoiceLimits> limits = limitsOf(options);
    if (!limits) return limits.diagnostics();
    answer.limits = std::move(*limits);
    ChoiceScope scope = options.scope;
    scope.motion = options.motion;
    const Status known = options.results.empty() ? measureScene(options, sources, answer)
                                                 : readResults(options, scope, answer);
    if (!known) return known.diagnostics();
    Result<Candidates> candidates = findCandidates(answer.samples, scope);
    if (!candidates) return candidates.diagnostics();
    answer.candidates = std::move(*candidates);
    Result<Choice> choice = choose(answer.candidates, answer.limits);
    if (!choice) return choice.diagnostics();
    answer.choice = std::move(*choice);
    return answer;
}

/// What to type to see it, settled where it remembers.
std::string renderCommand(const BenchSample& sample)
{
    std::string command = "crevice render " + sample.config;
    for (const std::string& value : sample.overrides) command += " --set " + value;
    return command + " --scene " + sample.scene + " --size " + sizeText(sample.extent) +
           " --out ao=ao.png --frames " + std::to_string(kGatheringFrames);
}

/// From the one of that place on.
void printOthers(const Answer& answer, const char* title, const std::vector<std::size_t>& others,
                 std::size_t first)
{
    if (others.size() <= first) return;
    print("%s\n", title);
    const std::size_t end = std::min(others.size(), first + kOthersShown);
    for (std::size_t i = first; i < end; ++i) {
        const Candidate& other = answer.candidates.list[others[i]];
        print("  %-44s error %s   %8s ms  %6s x learnopengl\n", other.label.c_str(),
              fixed(other.error, 4).c_str(), fixed(other.ms, 3).c_str(),
              fixed(other.ratio, 2).c_str());
    }
    if (others.size() > end) print("  and %zu more\n", others.size() - end);
}

/// "+4 %".
std::string changeText(double factor)
{
    const double percent = std::round((factor - 1.0) * 100.0);
    return (percent < 0 ? "-" : "+") + fixed(std::abs(percent), 0) + " %";
}

/// What only a measurement of this command knows: how sure it is, and where the error lies.
void printDetails(const BenchSample& best, const QuickDetails& details, bool by_time)
{
    print("  %s MB of textures; %s %% sure that no other measured one within is %s by over 5 %%\n",
          fixed(best.texture_bytes / 1e6, 1).c_str(), fixed(100.0 * details.sure, 0).c_str(),
          by_time ? "faster" : "less wrong");
    print("  too %s by %s in the mean; %s %% of the squared error is where it is too dark\n",
          best.error.bias < 0 ? "dark" : "bright", fixed(std::abs(best.error.bias), 4).c_str(),
          fixed(100.0 * details.dark, 0).c_str());
    const FrameShares& frame = details.frame;
    const double whole = frame.occlusion + frame.own_geometry + frame.geometry + frame.lighting;
    if (whole > 0)
        print(
            "  a whole frame, timed apart, takes %s ms: geometry %s, occlusion %s and its own "
            "geometry %s, lighting %s\n",
            significant(whole, 3).c_str(), significant(frame.geometry, 3).c_str(),
            significant(frame.occlusion, 3).c_str(), significant(frame.own_geometry, 3).c_str(),
            significant(frame.lighting, 3).c_str());
    if (!details.neighbours.empty()) print("the error by part: what each would change\n");
    for (const QuickDetails::Neighbour& each : details.neighbours)
        print("  %-44s error %7s   cost %7s%s\n", each.setting.c_str(),
              changeText(each.error).c_str(), changeText(each.cost).c_str(),
              each.rough ? "   in a small picture" : "");
}

void printAnswer(const Answer& answer)
{
    const bool by_time = wantsLeastTime(answer.limits);
    const Candidate& best = answer.best();
    const Candidates& all = answer.candidates;
    std::set<std::string> radii;
    for (const ResultView& view : all.views) radii.insert(significant(view.radius, 6));
    QuickDetails details;
    if (answer.quick) details = answer.quick->detailsOf(answer.bestSample());
    const auto around = [](double value, double margin, int digits) {
        const std::string text = fixed(value, digits);
        return margin > 0 ? text + " +- " + fixed(margin, digits) : text;
    };
    print("%s\n", best.label.c_str());
    print("  error %s (%s); adds %s ms a frame without geometry (%s), %s times learnopengl (%s)\n",
          around(best.error, details.error_margin, 4).c_str(), best.worst_view.c_str(),
          around(best.ms, details.ms_margin, 3).c_str(), best.slowest_view.c_str(),
          fixed(best.ratio, 2).c_str(), best.ratio_view.c_str());
    if (best.flicker > 0)
        print("  the error includes a flicker of %s\n", fixed(best.flicker, 4).c_str());
    print("  without ambient occlusion the error is %s\n", fixed(all.error_without_ao, 4).c_str());
    print("  %s%s at %s and radius %s on %s\n", all.views.size() > 1 ? "the worst of " : "",
          counted(all.views.size(), "scene").c_str(), sizeText(all.views[0].extent).c_str(),
          joined({radii.begin(), radii.end()}).c_str(), all.device.c_str());
    if (answer.quick) printDetails(answer.bestSample(), details, by_time);
    print("why: of %zu measured configs, %zu have %s; this one is the fastest of those%s\n",
          all.list.size(), answer.choice.within.size(), limitText(answer.limits).c_str(),
          by_time ? "" : " whose error is within 5 % of the lowest");
    if (details.ruled_out + details.not_begun > 0)
        print("not measured: %zu that small pictures ruled out, %zu that there was no time for\n",
              details.ruled_out, details.not_begun);
    printOthers(answer, "also within:", answer.choice.within, 1);
    printOthers(answer, "over a limit:", answer.choice.beyond, 0);
    for (const std::string& elided : all.elided) print("left out: %s\n", elided.c_str());
    for (const std::string& label : all.harmful)
        print("left out: %s: no better than no ambient occlusion\n", label.c_str());
    print("see it: %s\n", renderCommand(answer.bestSample()).c_str());
}

nlohmann::json toJson(const Candidate& candidate, const std::vector<BenchSample>& samples)
{
    const BenchSample& sample = samples[candidate.sample];
    return {{"config", sample.config},
            {"overrides", sample.overrides},
            {"samples", sample.samples},
            {"cost_ms", candidate.ms},
            {"ratio_learnopengl", candidate.ratio},
            {"rmse", candidate.error},
            {"flicker", candidate.flicker}};
}

void printAnswerJson(const Answer& answer)
{
    const auto list = [&answer](const std::vector<std::size_t>& others, std::size_t first) {
        nlohmann::json json = nlohmann::json::array();
        for (std::size_t i = first; i < others.size(); ++i)
            json.push_back(toJson(answer.candidates.list[others[i]], answer.samples));
        return json;
    };
    nlohmann::json json = {{"limit", limitText(answer.limits)},
                           {"device", answer.candidates.device},
                           {"best", toJson(answer.best(), answer.samples)},
                           {"also_within", list(answer.choice.within, 1)},
                           {"beyond", list(answer.choice.beyond, 0)},
                           {"elided", answer.candidates.elided},
                           {"harmful", answer.candidates.harmful}};
    if (answer.quick) {
        const QuickDetails details = answer.quick->detailsOf(answer.bestSample());
        json["sure"] = details.sure;
        json["rmse_margin"] = details.error_margin;
        json["cost_ms_margin"] = details.ms_margin;
        json["dark_share"] = details.dark;
        json["frame_ms"] = {{"geometry", details.frame.geometry},
                            {"occlusion", details.frame.occlusion},
                            {"own_geometry", details.frame.own_geometry},
                            {"lighting", details.frame.lighting}};
        json["parts"] = nlohmann::json::array();
        for (const QuickDetails::Neighbour& each : details.neighbours)
            json["parts"].push_back({{"set", each.setting},
                                     {"error", each.error},
                                     {"cost", each.cost},
                                     {"rough", each.rough}});
    }
    printAsJson(json);
}

/// JSON as a C string, which Effect::govern and crevice_effect_govern take as they take a file.
std::string asHeader(const std::string& json)
{
    std::string text =
        "/* A front, by crevice choose --write-front. */\nstatic const char front[] =";
    for (const std::string_view line : split(json, '\n')) text += "\n    " + jsonString(line);
    return text + ";\n";
}

/// What a governor steps along: all that no other beats, by rising cost, of those to which a host
/// hands the same, as Renderer::setLevels wants it. Errors: CV7007, those of loadDescription.
Status writeFront(const Answer& answer, ConfigOptions config, const SourceSet& sources,
                  const std::string& file)
{
    std::map<std::string, std::vector<Candidate>> groups;  // by what is handed to them
    for (const Candidate& each : answer.candidates.list) {
        config.config = answer.samples[each.sample].config;
        config.overrides = answer.samples[each.sample].overrides;
        const auto level = loadDescription(config, sources);
        if (!level) return level.diagnostics();
        std::set<std::string> needs;
        for (const ImportDesc& import : level->imports)
            if (!import.optional &&
                (import.type == ImportType::texture || import.type == ImportType::draw_list))
                needs.insert(import.name);
        groups[joined({needs.begin(), needs.end()})].push_back(each);
    }
    const auto largest = std::max_element(
        groups.begin(), groups.end(),
        [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    std::vector<std::string> left_out;
    for (const auto& [needs, group] : groups)
        for (const std::size_t i : frontOf(group))
            if (needs != largest->first) left_out.push_back(group[i].label + " takes " + needs);
    const std::vector<Candidate>& list = largest->second;
    const BenchSample& any = answer.samples.front();
    nlohmann::ordered_json front = {{"format", "crevice-front-1"},
                                    {"scene", any.scene},
                                    {"size", {any.extent.width, any.extent.height}},
                                    {"device", answer.candidates.device},
                                    {"levels", nlohmann::ordered_json::array()}};
    for (const std::size_t i : frontOf(list)) {
        const BenchSample& sample = answer.samples[list[i].sample];
        front["levels"].push_back({{"config", sample.config},
                                   {"set", sample.overrides},
                                   {"ms", list[i].ms},
                                   {"error", list[i].error}});
    }
    const std::string text = front.dump(2);
    const Status written = writeFile(file, endsWith(file, ".h") ? asHeader(text) : text + "\n");
    if (!written || left_out.empty()) return written;
    return asWarning({Code::reference_missing,
                      "left out of the front, whose levels take " + largest->first + ": " +
                          joined(left_out, "; "),
                      "name those to choose from by --config"});
}

/// All that can be wrong with the arguments, before anything slow begins.
Status checkOptions(const ChooseOptions& options, bool has_scene)
{
    if (options.results.empty() && !has_scene)
        return Diagnostic{Code::usage, "there is nothing to choose by",
                          "write crevice choose --scene model.glb --budget 2ms to measure now, or "
                          "name a folder of crevice bench"};
    Diagnostics diagnostics;
    if (!options.write.empty())
        append(diagnostics, checkPatchFile(options.config, options.write).diagnostics());
    const std::string& front = options.write_front;
    if (!front.empty() && !endsWith(front, ".json") && !endsWith(front, ".h"))
        diagnostics.push_back({Code::usage, "--write-front '" + front + "' is no .json and no .h",
                               "write --write-front front.json, or front.h for a C array"});
    if (!front.empty()) append(diagnostics, checkWritable(front).diagnostics());
    return diagnostics;
}

int chooseConfig(const ChooseOptions& options, bool has_scene)
{
    const CheckoutSources sources(options.config.checkout, options.config.roots);
    const Status right = checkOptions(options, has_scene);
    if (!right) return report(right.diagnostics(), options.json);
    const Result<Answer> answer = answerFor(options, sources);
    if (!answer) return report(answer.diagnostics(), options.json);
    report(answer->warnings, false);
    if (!answer->limits.empty()) (options.json ? printAnswerJson : printAnswer)(*answer);
    ConfigOptions chosen = options.config;
    chosen.config = answer->bestSample().config;
    chosen.overrides = answer->bestSample().overrides;
    Diagnostics written;
    const auto add = [&written](const std::string& file, const Status& done) {
        append(written, done.diagnostics());
        if (done) printMessage("wrote %s\n", printableLine(file).c_str());
    };
    if (!options.write.empty()) add(options.write, savePatch(chosen, sources, options.write));
    if (!options.write_front.empty())
        add(options.write_front, writeFront(*answer, chosen, sources, options.write_front));
    return report(written, false);
}

}  // namespace

void addChooseCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("choose", "Name the best config for a time or an error");
    auto options = std::make_shared<ChooseOptions>();
    command->add_option("RESULTS", options->results,
                        "Folders of 'crevice bench', or the results files in them. Without any "
                        "the scene is measured now");
    addSceneOptions(*command, options->scene);
    addList(*command, "--config", options->configs, "NAME",
            "A shipped config's name or a file; may be repeated. Default: all shipped ones");
    addList(*command, "--set", options->config.overrides, "NAME=VALUE",
            "Set a value in every config, as for crevice render; may be repeated");
    addBackendOption(*command, options->backend);
    command->add_option("--time-budget", options->run.time_budget,
                        "Measure for at most this time: 90s, 5m. Default: 50s");
    for (CLI::Option* each : command->get_options())
        if (!contains({"--help", "RESULTS", "--scene", "--size", "--root"}, each->get_name()))
            each->excludes("RESULTS");
    command->add_option("--budget", options->budget,
                        "Name the config with the lowest error that adds at most this time to a "
                        "frame that has its geometry: 2ms, 500us, or 0.5x for half the time of "
                        "learnopengl");
    command
        ->add_option("--error", options->error,
                     "Name the fastest config whose rmse is at most this, such as 0.06; with "
                     "--budget both must hold")
        ->check(aboveZero("0.06"));
    command->add_flag("--motion", options->motion,
                      "Count flicker as error: the root of rmse^2 + flicker^2");
    addCheckoutOption(*command, options->config.checkout);
    addText(*command, "--write", options->write, "FILE.json", "Write the config that is named");
    addText(*command, "--write-front", options->write_front, "FILE",
            "Write all configs that no other beats, for a governor, as JSON or, where it ends in "
            ".h, as a C array; needs no limit");
    command
        ->add_option("--device", options->scope.device,
                     "Only results of this device: a part of its name, such as llvmpipe")
        ->needs("RESULTS");
    command->add_flag("--json", options->json, "Print the answer as JSON");
    command->footer(
        "Examples:\n"
        "  crevice choose --scene model.glb --budget 2ms --write mine.json\n"
        "  crevice choose --scene model.glb --error 0.05 --motion\n"
        "  crevice choose bench --budget 2ms\n"
        "  crevice choose bench --error 0.06 --scene room");
    command->callback([options, command, &exit_code] {
        const bool has_scene = command->count("--scene") > 0;
        if (!options->results.empty()) {  // these then say which of the results
            if (!has_scene) options->scene.scene.clear();
            if (command->count("--size") == 0) options->scene.size.clear();
        }
        options->config.roots = options->scene.import.roots;
        exit_code = chooseConfig(*options, has_scene);
    });
}

}  // namespace crevice
