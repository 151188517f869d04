// SPDX-License-Identifier: MIT
#include "tools/measure/bench/quick.h"

#include "core/base/text.h"
#include "tools/commands/cli/load_config.h"
#include "tools/commands/cli/output.h"
#include "tools/measure/line_file.h"
#include "tools/measure/taps.h"
#include "tools/show/plan/print.h"

#include <set>

namespace crevice {
namespace {

/// The share of the time after which no further config is begun.
constexpr double kFirstShare = 0.4;

/// What a config with other values did at full size may be off by this from what it did.
constexpr double kKinOff = 1.25;

constexpr std::size_t kMostPixels = 128000;

/// Configs that a first look is at, if there are as many; else all presets.
constexpr std::size_t kLeastFirst = 4;

/// How far beyond a limit one may be whose neighbours are tried.
constexpr double kSlack[] = {1.0, 1.25, 1.6, 2.0};

double medianOfTurns(const std::vector<double>& values)
{
    return values.empty() ? 0.0 : timeFigures(values).median;
}

/// Never surer than what a bench settles for.
Range intervalOf(const std::vector<double>& values)
{
    constexpr double kNever = 1e30;  // there is nothing that it is measured by
    if (values.empty()) return {kNever, kNever, kNever};
    const TimeFigures figures = timeFigures(values);
    const double margin = std::max(kSettledMargin, medianMargin(figures, values.size()));
    return rangeOf(figures.median, figures.median * margin);
}

/// All shipped ones where none is named: presets first, then by the number of their taps.
QuickOptions withConfigs(QuickOptions options, const SourceSet& sources)
{
    if (!options.configs.empty()) return options;
    std::set<std::pair<int, std::string>> sorted;
    for (const std::string& name : configNames(sources))
        if (const auto loaded = loadDescription({name, {}, {}, {}}, sources))
            sorted.emplace(isPresetConfig(name) ? -1 : samplesOf(*loaded), name);
    for (const auto& [taps, name] : sorted) options.configs.push_back(name);
    return options;
}

/// What a figure became at full size: of the same config with other values, else of all.
template <class Figure>
Range growthOf(const Entrant& entrant, const std::deque<Entrant>& all, Figure&& figure)
{
    std::vector<double> factors;
    for (const Entrant& other : all) {
        if (!other.small || !other.full || figure(other.small) <= 0) continue;
        const double factor = figure(other.full) / figure(other.small);
        if (other.config == entrant.config) return {factor, factor / kKinOff, factor * kKinOff};
        factors.push_back(factor);
    }
    return factorOf(factors);
}

double errorOf(const Look& look) { return look.with_flicker; }
double costOf(const Look& look) { return medianOfTurns(look.milliseconds()); }
double ratioOf(const Look& look) { return medianOfTurns(look.ratios); }

/// As --set has them.
std::set<std::string> settingsOf(const Entrant& entrant)
{
    std::set<std::string> all(entrant.overrides.begin(), entrant.overrides.end());
    for (const ParamDesc& param : entrant.description.params)
        all.insert(param.name + "=" + significant(param.value[0], 6));
    for (const FeatureDesc& feature : entrant.description.features)
        all.insert(feature.name + "=" + feature.values[feature.value]);
    return all;
}

/// "steps=9" where that is all that `other` has otherwise; else nothing.
std::string settingApart(const Entrant& entrant, const Entrant& other)
{
    const std::set<std::string> own = settingsOf(entrant), its = settingsOf(other);
    std::vector<std::string> apart;
    std::set_difference(its.begin(), its.end(), own.begin(), own.end(), std::back_inserter(apart));
    return other.config == entrant.config && apart.size() == 1 ? apart[0] : "";
}

Standing asMeasured(const Look& look)
{
    return {intervalOf(look.milliseconds()), intervalOf(look.ratios),
            rangeOf(look.with_flicker, look.error.margin), true, &look.error};
}

}  // namespace

QuickBench::QuickBench(Device& device, const BenchView& view, const SourceSet& sources,
                       QuickOptions options)
    : sources_(sources),
      options_(withConfigs(std::move(options), sources)),
      start_s_(clockSeconds()),
      meter_(
          device, view, sources,
          {options_.scene, options_.roots, options_.motion, options_.version, options_.interrupted})
{
}

double QuickBench::seconds() const { return clockSeconds() - start_s_; }

Standing QuickBench::standingOf(const Entrant& entrant) const
{
    if (entrant.full) return asMeasured(entrant.full);
    const Standing is = asMeasured(entrant.small);
    return {scaled(is.ms, growthOf(entrant, entrants_, costOf)),
            scaled(is.ratio, growthOf(entrant, entrants_, ratioOf)),
            scaled(is.error, growthOf(entrant, entrants_, errorOf))};
}

std::vector<Standing> QuickBench::standings() const
{
    std::vector<Standing> all;
    for (const Entrant& entrant : entrants_) all.push_back(standingOf(entrant));
    return all;
}

/// Says the leader where it is another than before, or which one leads in small pictures.
void QuickBench::sayLeader(bool first_look)
{
    std::vector<Standing> all = standings();
    for (Standing& standing : all) standing.measured |= first_look;
    const auto first = leaderOf(all, options_.limits);
    const std::string small = "a first look, in a picture of " + sizeText(meter_.smallExtent());
    const std::string at = fixed(seconds(), 0) + " s: " + (first_look ? small + ": " : "");
    if (!first && first_look && !all.empty())
        options_.say(at + "the nearest to the limits is " +
                     entrants_[nearestOf(all, options_.limits)].label());
    if (!first || (entrants_[*first].label() == leader_ && !first_look)) return;
    leader_ = first_look ? "" : entrants_[*first].label();
    const Standing& it = all[*first];
    options_.say(at + entrants_[*first].label() + ", error " + fixed(it.error.value, 3) + " (" +
                 fixed(it.error.low, 3) + " to " + fixed(it.error.high, 3) + "), " +
                 significant(it.ms.value, 3) + " ms" + (first_look ? " there" : ""));
}

/// Draws a config in the small picture, and keeps it where its occlusion is one of its own. A
/// feature must change passes: what it changes in shaders alone may be there for what no error
/// tells, such as ghosts of a history.
void QuickBench::enter(Entrant entrant)
{
    const std::string label = entrant.label();
    if (anyOf(entrants_, [&](const Entrant& each) { return each.label() == label; })) return;
    Status done = meter_.load(entrant);
    const std::string set = entrant.setting.substr(0, entrant.setting.find('='));
    const bool is_neighbour = !entrant.setting.empty();
    const bool by_feature = findNamed(entrant.description.features, set) != nullptr;
    const auto same = [&](const Entrant& each) {
        return each.passes == entrant.passes && (by_feature || each.programs == entrant.programs);
    };
    if (done && anyOf(entrants_, same)) return;
    entrants_.push_back(std::move(entrant));
    looked_at_ = label;
    if (done) done = meter_.lookSmall(entrants_.back(), !is_neighbour);
    if (done) return;
    // Of a neighbour, values do not go together.
    leaveOut(label, is_neighbour ? Diagnostics() : done.diagnostics());
}

void QuickBench::leaveOut(const std::string& label, const Diagnostics& why)
{
    eraseIf(entrants_, [&](const Entrant& each) { return each.label() == label; });
    if (why.empty()) return;
    const Diagnostic& error = firstError(why);
    warnings_.push_back(asWarning({error.code, label + " is left out: " + error.message}));
}

void QuickBench::settle(const Status& taken)
{
    if (taken) {
        meter_.finish();
    } else {
        meter_.drop();
        leaveOut(looked_at_, taken.diagnostics());
    }
    if (stage_ > Stage::first_look) sayLeader();
}

/// The next config. False where there is none, or no time for one.
bool QuickBench::enterNext()
{
    if (next_config_ == options_.configs.size() || seconds() > kFirstShare * options_.time_s)
        return false;
    enter({options_.configs[next_config_++], options_.overrides});
    return true;
}

/// The leader, or else the nearest that would lead were it within the limits: whichever has no
/// neighbours yet.
std::optional<std::size_t> QuickBench::withoutNeighbours() const
{
    for (const double slack : kSlack) {
        ChoiceLimits limits = options_.limits;
        for (ChoiceLimit& limit : limits) limit.most *= slack;
        const auto first = leaderOf(standings(), limits);
        if (first && !entrants_[*first].has_neighbours) return first;
    }
    return std::nullopt;
}

/// False where all that matter have theirs.
bool QuickBench::enterNeighbours()
{
    const auto place = withoutNeighbours();
    if (!place) return false;
    entrants_[*place].has_neighbours = true;
    looked_at_ = entrants_[*place].label();
    const Status drawn = meter_.lookSmall(entrants_[*place], false);  // its cost was rough
    if (!drawn) return true;
    const std::string of = looked_at_, config = entrants_[*place].config;
    const std::vector<std::string> own = entrants_[*place].overrides;
    std::vector<std::string> settings = neighbourSettings(entrants_[*place].description);
    for (std::string& swap : filterSwaps(sources_, {config, {}, own, options_.roots}))
        settings.push_back(std::move(swap));
    for (const std::string& setting : settings)
        to_enter_.push_back({config, withSetting(own, setting), setting, of});
    return true;
}

/// What cannot be drawn there is out.
void QuickBench::lookFull(std::size_t place)
{
    looked_at_ = entrants_[place].label();
    const Status drawn = meter_.lookFull(entrants_[place]);
    if (!drawn) leaveOut(looked_at_, drawn.diagnostics());
}

/// False where nothing could lead that was not measured.
bool QuickBench::race()
{
    if (!to_enter_.empty()) {
        Entrant next = std::move(to_enter_.front());
        to_enter_.pop_front();
        enter(std::move(next));
        return true;
    }
    const auto next = nextOf(standings(), options_.limits, options_.whole_front);
    if (next) lookFull(*next);
    return next || enterNext() || enterNeighbours();
}

/// What is next to the leader, then more pixels and turns for it and for the next best. False where
/// all of that is done.
bool QuickBench::refine()
{
    std::vector<Standing> all = standings();
    const auto first = leaderOf(all, options_.limits);
    if (!first) return false;
    if (stage_ == Stage::kin) {
        for (const Entrant& each : entrants_)
            if (each.of == entrants_[*first].label() && !each.full)
                to_look_at_.push_back(each.label());
        stage_ = Stage::pixels;
    }
    if (!to_look_at_.empty()) {
        const std::string label = to_look_at_.front();
        to_look_at_.pop_front();
        for (std::size_t i = 0; i < entrants_.size(); ++i)
            if (entrants_[i].label() == label) return lookFull(i), true;
        return true;
    }
    const Result<bool> grown = meter_.grow(pixels_);
    if (!grown || *grown) return grown.ok();
    if (looked_by_ == pixels_) {
        pixels_ *= 2;
        return pixels_ <= kMostPixels;
    }
    looked_by_ = pixels_;
    to_look_at_.push_back(entrants_[*first].label());
    all[*first].measured = false;
    if (const auto second = leaderOf(all, options_.limits))
        to_look_at_.push_back(entrants_[*second].label());
    return true;
}

Result<bool> QuickBench::step()
{
    switch (stage_) {
    case Stage::begin: {
        Entrant first{options_.configs.front(), options_.overrides};
        if (const Status begun = meter_.begin(first); !begun) return begun.diagnostics();
        stage_ = Stage::first_look;
        return true;
    }
    case Stage::first_look: {
        const auto presets =
            std::count_if(options_.configs.begin(), options_.configs.end(), isPresetConfig);
        if (next_config_ < std::max<std::size_t>(kLeastFirst, presets) && enterNext()) return true;
        sayLeader(true);
        if (const Status opened = meter_.openFull(); !opened) return opened.diagnostics();
        stage_ = Stage::truth;
        return true;
    }
    case Stage::truth: {
        const Result<bool> grown = meter_.grow(kFullPixels);
        if (grown && !*grown) stage_ = Stage::race;
        return grown ? Result<bool>(true) : grown;
    }
    case Stage::race: {
        if (!mustStop() && race()) return true;
        stage_ = Stage::kin;
        const auto is_known = [](const Entrant& each) { return static_cast<bool>(each.full); };
        if (!anyOf(entrants_, is_known) && !entrants_.empty())  // so that it can say how far it is
            lookFull(nearestOf(standings(), options_.limits));
        return true;
    }
    default: return !mustStop() && refine();
    }
}

Status QuickBench::run()
{
    for (bool more = true; more;) {
        const Result<bool> stepped = step();
        if (!stepped) return stepped.diagnostics();
        more = *stepped;
        if (Turns* due = turns()) settle(due->take(options_.interrupted));
    }
    if (const auto best = leaderOf(standings(), options_.limits); best && !options_.interrupted())
        if (const auto shares = meter_.sharesOf(entrants_[*best])) shares_ = *shares;
    return warnings_;
}

std::vector<BenchSample> QuickBench::samples() const
{
    std::vector<BenchSample> samples;
    for (const Entrant& entrant : entrants_)
        if (entrant.full) samples.push_back(meter_.sampleOf(entrant));
    return samples;
}

QuickDetails QuickBench::detailsOf(const BenchSample& sample) const
{
    QuickDetails details;
    std::size_t place = 0;
    while (place < entrants_.size() && entrants_[place].label() != sampleLabel(sample)) ++place;
    if (place == entrants_.size()) return details;
    const Entrant& it = entrants_[place];
    const Range ms = intervalOf(it.full.milliseconds());
    details.error_margin = it.full.error.margin;
    details.ms_margin = ms.high - ms.value;
    details.sure = sureness(standings(), place, options_.limits);
    details.dark = it.full.error.dark;
    details.ruled_out = std::count_if(entrants_.begin(), entrants_.end(),
                                      [](const Entrant& each) { return !each.full; });
    details.not_begun = options_.configs.size() - next_config_;
    if (it.label() == leader_) details.frame = shares_;
    for (const Entrant& other : entrants_) {
        const std::string setting = settingApart(it, other);
        if (setting.empty()) continue;
        const Look &its = other.full ? other.full : other.small,
                   &own = other.full ? it.full : it.small;
        details.neighbours.push_back(
            {setting, errorOf(its) / errorOf(own), costOf(its) / costOf(own), !other.full});
    }
    return details;
}

}  // namespace crevice
