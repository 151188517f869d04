// SPDX-License-Identifier: MIT
// crevice choose: the best measured config for a time or an error, and why.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/bench/choice.h"
#include "tools/render/scene/options.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace crevice {
namespace {

/// How many other configs are printed on either side of the limit.
constexpr std::size_t kOthersShown = 4;

struct ChooseOptions {
    std::vector<std::string> results;
    std::string budget;
    double error = 0;
    std::string size;
    ChoiceScope scope;
    bool json = false;
};

/// A question that was answered.
struct Answer {
    std::vector<BenchSample> samples;
    Candidates candidates;
    ChoiceLimit limit;
    Choice choice;
    Diagnostics warnings;

    const Candidate& best() const { return candidates.list[choice.within.front()]; }
};

Result<Answer> answerFor(ChooseOptions options)
{
    if (options.budget.empty() == (options.error == 0))
        return Diagnostic{Code::usage, "crevice choose wants one of --budget and --error",
                          "write --budget 2ms for the most accurate config within a time, or "
                          "--error 0.06 for the fastest within an error"};
    Answer answer;
    answer.limit = {ChoiceLimit::Kind::error, options.error};
    if (!options.budget.empty()) {
        const Result<ChoiceLimit> budget = parseBudget(options.budget);
        if (!budget) return budget.diagnostics();
        answer.limit = *budget;
    }
    if (!options.size.empty()) {
        const Result<Extent> extent = parseSize(options.size);
        if (!extent) return extent.diagnostics();
        options.scope.extent = *extent;
    }
    Result<std::vector<BenchSample>> samples = readBenchSamples(options.results);
    if (!samples) return samples.diagnostics();
    answer.warnings = samples.diagnostics();
    answer.samples = std::move(*samples);
    Result<Candidates> candidates = findCandidates(answer.samples, options.scope);
    if (!candidates) return candidates.diagnostics();
    answer.candidates = std::move(*candidates);
    Result<Choice> choice = choose(answer.candidates, answer.limit);
    if (!choice) return choice.diagnostics();
    answer.choice = std::move(*choice);
    return answer;
}

/// What to type to see it.
std::string renderCommand(const BenchSample& sample)
{
    std::string command = "crevice render " + sample.config;
    for (const std::string& value : sample.overrides) command += " --set " + value;
    return command + " --scene " + sample.scene + " --size " + extentName(sample.extent);
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
        print("  %-44s error %s   %8s ms  %7s x copy\n", other.label.c_str(),
              fixed(other.error, 4).c_str(), fixed(other.ms, 3).c_str(),
              fixed(other.ratio, 1).c_str());
    }
    if (others.size() > end) print("  and %zu more\n", others.size() - end);
}

void printAnswer(const Answer& answer)
{
    const bool by_error = answer.limit.kind == ChoiceLimit::Kind::error;
    const Candidate& best = answer.best();
    const Candidates& all = answer.candidates;
    print("%s\n", best.label.c_str());
    print("  error %s (%s); adds %s ms a frame (%s), %s times a depth copy\n",
          fixed(best.error, 4).c_str(), best.worst_view.c_str(), fixed(best.ms, 3).c_str(),
          best.slowest_view.c_str(), fixed(best.ratio, 1).c_str());
    print("  without ambient occlusion the error is %s\n", fixed(all.error_without_ao, 4).c_str());
    print("  %s%zu %s at %s on %s\n", all.views.size() > 1 ? "the worst of " : "", all.views.size(),
          all.views.size() > 1 ? "scenes" : "scene", extentName(all.views[0].extent).c_str(),
          all.device.c_str());
    print("why: of %zu configs, %zu have %s; this one %s of those\n", all.list.size(),
          answer.choice.within.size(), limitText(answer.limit).c_str(),
          by_error ? "is the fastest" : "has the lowest error");
    printOthers(answer,
                by_error ? "also within the error, but slower:"
                         : "also within the time, but with a larger error:",
                answer.choice.within, 1);
    printOthers(answer, by_error ? "error too large:" : "too slow:", answer.choice.beyond, 0);
    for (const std::string& elided : all.elided) print("left out: %s\n", elided.c_str());
    for (const std::string& label : all.harmful)
        print("left out: %s: no better than no ambient occlusion\n", label.c_str());
    print("see it: %s\n", renderCommand(answer.samples[best.sample]).c_str());
}

nlohmann::json toJson(const Candidate& candidate, const std::vector<BenchSample>& samples)
{
    const BenchSample& sample = samples[candidate.sample];
    return {{"config", sample.config}, {"overrides", sample.overrides}, {"samples", sample.samples},
            {"cost_ms", candidate.ms}, {"ratio_copy", candidate.ratio}, {"rmse", candidate.error}};
}

void printAnswerJson(const Answer& answer)
{
    const auto list = [&answer](const std::vector<std::size_t>& others, std::size_t first) {
        nlohmann::json json = nlohmann::json::array();
        for (std::size_t i = first; i < others.size(); ++i)
            json.push_back(toJson(answer.candidates.list[others[i]], answer.samples));
        return json;
    };
    printAsJson({{"limit", limitText(answer.limit)},
                 {"device", answer.candidates.device},
                 {"best", toJson(answer.best(), answer.samples)},
                 {"also_within", list(answer.choice.within, 1)},
                 {"beyond", list(answer.choice.beyond, 0)},
                 {"elided", answer.candidates.elided},
                 {"harmful", answer.candidates.harmful}});
}

int chooseConfig(const ChooseOptions& options)
{
    const Result<Answer> answer = answerFor(options);
    if (!answer) return report(answer.diagnostics(), options.json);
    report(answer->warnings, false);
    (options.json ? printAnswerJson : printAnswer)(*answer);
    return kExitOk;
}

}  // namespace

void addChooseCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command =
        app.add_subcommand("choose", "Name the best measured config for a time or an error");
    auto options = std::make_shared<ChooseOptions>();
    command
        ->add_option("RESULTS", options->results,
                     "Folders of 'crevice bench', or the results files in them")
        ->required();
    command->add_option("--budget", options->budget,
                        "Name the config with the lowest error that adds at most this time to a "
                        "frame: 2ms, 500us, or 10x for ten times a copy of the depth texture");
    command
        ->add_option("--error", options->error,
                     "Name the fastest config whose rmse is at most this, such as 0.06")
        ->check(aboveZero("0.06"));
    command->add_option(
        "--scene", options->scope.scene,
        "Only results of this scene; otherwise each config counts with its worst scene");
    command->add_option("--size", options->size, "Only results of this size, such as 1920x1080");
    command->add_option("--device", options->scope.device,
                        "Only results of this device: a part of its name, such as llvmpipe");
    command->add_flag("--json", options->json, "Print the answer as JSON");
    command->footer(
        "Examples:\n"
        "  crevice choose bench --budget 2ms\n"
        "  crevice choose bench --error 0.06 --scene room");
    command->callback([options, &exit_code] { exit_code = chooseConfig(*options); });
}

}  // namespace crevice
