// SPDX-License-Identifier: MIT
// From judged series to sentences.
#include "tools/measure/stress/breakdown.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace crevice {
namespace {

constexpr std::size_t kMostOthers = 4;  // other cases in one sentence

/// A point, and what others are joined with it by.
struct Found {
    BreakdownPoint point;
    std::string cause;  ///< The same in cases that tell the same.
    double held = 0;    ///< The figures as numbers.
    double broke = 0;
};

double figureOf(const StressCondition& condition, const StressRecord& record)
{
    switch (condition.quantity) {
    case Quantity::screens: return record.radius_px / std::max(record.height_px, 1);
    case Quantity::pixels: return record.radius_px;
    case Quantity::value: return std::abs(record.value) * condition.scale;
    case Quantity::label: break;
    }
    return record.value;
}

std::string figureText(const StressCondition& condition, const StressRecord& record)
{
    if (condition.quantity == Quantity::label) return record.label;
    const double figure = figureOf(condition, record);
    return figure >= 100 && figure < 1e6 ? fixed(figure, 0) : significant(figure, 2);
}

std::string filledIn(std::string text, const std::string& figure)
{
    const std::size_t at = text.find("{}");
    if (at != std::string::npos) text.replace(at, 2, figure);
    return text;
}

Verdict verdictOf(const StressSeries& series, std::size_t step)
{
    Verdict verdict = judge(*series.stress, series.steps, step);
    if (verdict.outcome == Outcome::beyond)
        verdict.why += ", more than " + series.steps[step]->stored + " can resolve";
    return verdict;
}

Found foundAt(const StressSeries& series, std::size_t step, const Verdict& verdict)
{
    const StressCase& stress = *series.stress;
    Found found;
    BreakdownPoint& point = found.point;
    point.config = series.config;
    point.stress = &stress;
    point.format = series.format;
    point.after = series.steps[step];
    point.steps_off = std::abs(static_cast<int>(step) - static_cast<int>(stress.ordinary));
    point.effect = verdict.effect;
    point.why = verdict.why;
    point.likelihood = stress.words.likelihood;
    point.because = stress.words.because;
    return found;
}

std::string formatText(const std::string& format)
{
    return format.empty() ? "" : " with " + format.substr(format.find('=') + 1);
}

/// What does no harm, or none but that of the ordinary picture.
bool isFine(const Verdict& verdict)
{
    return verdict.outcome == Outcome::holds || verdict.outcome == Outcome::invalid ||
           (verdict.outcome == Outcome::beyond && verdict.effect.empty());
}

/// What is wrong without anything out of the ordinary. Returns whether that is all there is to say.
bool findOrdinary(const StressSeries& series, std::vector<Found>& all)
{
    const std::size_t ordinary = series.stress->ordinary;
    if (!series.steps[ordinary]) return false;
    const Verdict verdict = verdictOf(series, ordinary);
    if (verdict.effect.empty()) return false;
    Found found = foundAt(series, ordinary, verdict);
    found.cause = "ordinary";
    found.point.likelihood = Likelihood::every;
    found.point.because = "ordinary pictures show it";
    if (verdict.outcome != Outcome::invalid)
        found.point.condition = "in the ordinary picture" + formatText(series.format);
    all.push_back(std::move(found));
    return verdict.outcome != Outcome::invalid;
}

/// The first step of a side that breaks, on the way from the ordinary one.
void findAmount(const StressSeries& series, int direction, std::vector<Found>& all)
{
    const StressCase& stress = *series.stress;
    const StressCondition& condition = direction > 0 ? stress.words.up : stress.words.down;
    const StressRecord* before = series.steps[stress.ordinary];
    for (int i = static_cast<int>(stress.ordinary) + direction;
         before && i >= 0 && i < static_cast<int>(stress.steps.size()); i += direction) {
        if (!series.steps[i]) continue;
        const Verdict verdict = verdictOf(series, i);
        if (isFine(verdict)) before = series.steps[i];
        if (isFine(verdict) || verdict.effect.empty()) continue;
        Found found = foundAt(series, i, verdict);
        found.cause = condition.where;
        found.held = figureOf(condition, *before);
        found.broke = figureOf(condition, *series.steps[i]);
        found.point.before = before;
        found.point.held = figureText(condition, *before);
        found.point.broke = figureText(condition, *series.steps[i]);
        found.point.condition =
            filledIn(std::string(condition.where), found.point.held) + formatText(series.format);
        all.push_back(std::move(found));
        return;
    }
}

/// "a, b or c" of three lines.
std::string listed(std::string lines)
{
    const std::size_t last = lines.rfind('\n');
    if (last != std::string::npos) lines.replace(last, 1, " or ");
    for (std::size_t at; (at = lines.find('\n')) != std::string::npos;) lines.replace(at, 1, ", ");
    return lines;
}

/// All kinds that break, those of one effect together, shown by the one that changes most: there
/// is no way from one to the next.
void findKinds(const StressSeries& series, std::vector<Found>& all)
{
    const StressCase& stress = *series.stress;
    const std::size_t first = all.size();
    for (std::size_t i = 0; i < stress.steps.size(); ++i) {
        if (!series.steps[i] || i == stress.ordinary) continue;
        const Verdict verdict = verdictOf(series, i);
        if (isFine(verdict) || verdict.effect.empty()) continue;
        const Found found = foundAt(series, i, verdict);
        std::size_t same = first;
        while (same < all.size() && all[same].point.effect != verdict.effect) ++same;
        if (same == all.size()) all.push_back(found);
        BreakdownPoint& point = all[same].point;
        point.condition += (point.condition.empty() ? "" : "\n") + stress.steps[i].label;
        if (found.point.after->change > point.after->change) {
            point.after = found.point.after;
            point.why = verdict.why;
        }
    }
    for (std::size_t i = first; i < all.size(); ++i) {
        all[i].cause = stress.name;
        BreakdownPoint& point = all[i].point;
        point.steps_off = 1;
        point.before = series.steps[stress.ordinary];
        point.held = stress.steps[stress.ordinary].label;
        point.broke = point.after->label;
        point.condition = filledIn(std::string(stress.words.up.where), listed(point.condition)) +
                          formatText(series.format);
    }
}

std::vector<Found> findAll(const std::vector<StressSeries>& all)
{
    std::vector<Found> found;
    for (const StressSeries& series : all) {
        if (findOrdinary(series, found)) continue;
        if (series.stress->unit.empty()) {
            findKinds(series, found);
            continue;
        }
        findAmount(series, 1, found);
        findAmount(series, -1, found);
    }
    return found;
}

/// Whether `other`, of the config's own format, tells what `found` does.
bool isTold(const Found& found, const Found& other)
{
    const BreakdownPoint &point = found.point, &own = other.point;
    return !point.format.empty() && own.format.empty() && point.config == own.config &&
           point.stress == own.stress && point.effect == own.effect && found.cause == other.cause &&
           own.steps_off <= point.steps_off;
}

bool tellTheSame(const Found& a, const Found& b)
{
    return a.point.config == b.point.config && a.point.effect == b.point.effect &&
           a.cause == b.cause && a.point.format == b.point.format;
}

bool breaksFirst(const Found& found, const Found& other)
{
    const double sign = found.broke > found.held ? 1 : -1;
    return std::make_pair(sign * found.held, sign * found.broke) <
           std::make_pair(sign * other.held, sign * other.broke);
}

std::string otherName(const BreakdownPoint& point)
{
    const bool amount = !point.stress->unit.empty() && !point.broke.empty();
    return "`" + point.stress->name + "`" + (amount ? " at " + point.broke : "");
}

/// Makes one of two that tell the same.
void join(Found& into, Found from)
{
    if (breaksFirst(from, into)) std::swap(into, from);
    if (from.point.stress != into.point.stress)  // else its other side
        into.point.others.push_back(otherName(from.point));
    into.point.others.insert(into.point.others.end(), from.point.others.begin(),
                             from.point.others.end());
    into.point.steps_off = std::min(into.point.steps_off, from.point.steps_off);
    if (from.point.likelihood >= into.point.likelihood) return;
    into.point.likelihood = from.point.likelihood;
    into.point.because = from.point.because;
}

std::string sceneText(const BreakdownPoint& point)
{
    std::string text(point.stress->words.seen);
    const std::size_t count = point.others.size();
    if (count == 0) return text;
    text += text.empty() ? "also " : "; also ";
    if (count > kMostOthers) return text + std::to_string(count) + " other cases";
    for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + point.others[i];
    return text;
}

}  // namespace

std::vector<BreakdownPoint> breakdownPoints(const std::vector<StressSeries>& all)
{
    const std::vector<Found> found = findAll(all);
    std::vector<Found> joined;
    std::vector<std::string> configs;
    for (const Found& each : found) {
        if (std::any_of(found.begin(), found.end(),
                        [&](const Found& other) { return isTold(each, other); }))
            continue;
        const auto same = std::find_if(joined.begin(), joined.end(), [&](const Found& other) {
            return tellTheSame(each, other);
        });
        if (same != joined.end())
            join(*same, each);
        else
            joined.push_back(each);
        if (configs.empty() || configs.back() != each.point.config)
            configs.push_back(each.point.config);
    }
    const auto placeOf = [&](const Found& each) {
        const auto config = std::find(configs.begin(), configs.end(), each.point.config);
        return std::make_tuple(config - configs.begin(), each.point.likelihood,
                               each.point.steps_off);
    };
    std::stable_sort(joined.begin(), joined.end(),
                     [&](const Found& a, const Found& b) { return placeOf(a) < placeOf(b); });
    std::vector<BreakdownPoint> points;
    for (Found& each : joined) points.push_back(std::move(each.point));
    return points;
}

std::string sentenceOf(const BreakdownPoint& point)
{
    std::string text = "AO of `" + point.config + "` " + point.effect;
    if (!point.condition.empty()) text += " " + point.condition;
    const bool amount = !point.stress->unit.empty() && !point.broke.empty();
    text += ": " + (amount ? "at " + point.broke + ", " : "") + point.why;
    const std::string scene = sceneText(point);
    return text + (scene.empty() ? "." : " (" + scene + ").");
}

std::string nameOf(Likelihood likelihood)
{
    const char* const names[] = {"every application", "many applications", "few applications",
                                 "only broken input"};
    return names[static_cast<int>(likelihood)];
}

std::string likelihoodOf(const BreakdownPoint& point)
{
    const bool many = point.likelihood == Likelihood::many || point.likelihood == Likelihood::few;
    std::string name = nameOf(point.likelihood);
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name + (many ? " meet it: " : " meets it: ") + point.because + ".";
}

}  // namespace crevice
