// SPDX-License-Identifier: MIT
// From axes to cells: all combinations, those that are listed, or a cover of all pairs of values.
#include "tools/measure/matrix/matrix.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>

namespace crevice {
namespace {

bool matches(const MatrixWhere& where, const MatrixChoice& choice)
{
    return allOf(where, [&](const auto& each) { return each.second.count(choice[each.first]); });
}

/// What files may be called: others become '_'.
std::string fileName(const std::string& name)
{
    std::string file = name;
    for (char& c : file)
        if (!isWord(c) && std::string_view("+-=.").find(c) == std::string_view::npos) c = '_';
    return file;
}

/// Names of the values of axes that have several, but for one axis.
std::string choiceName(const Matrix& matrix, const MatrixChoice& choice, const char* separator,
                       std::size_t left_out)
{
    std::vector<std::string> names;
    for (std::size_t axis = 0; axis < choice.size(); ++axis) {
        const std::string& name = matrix.value(choice, axis).name;
        if (axis == left_out || matrix.axes[axis].values.size() < 2 || name.empty()) continue;
        names.push_back(axis > kBackendAxis ? matrix.axes[axis].name + "=" + name : name);
    }
    if (names.empty()) names.push_back(matrix.value(choice, kConfigAxis).name);
    return joined(names, separator);
}

/// Every combination that is asked for, in the order of drawing. Requires at most kMaxMatrixCells.
std::vector<MatrixChoice> combinations(const Matrix& matrix)
{
    // Slowest first: what neighbours share.
    std::vector<std::size_t> order = {kBackendAxis, kSceneAxis, kCameraAxis, kSizeAxis};
    for (std::size_t axis = 0; axis < matrix.axes.size(); ++axis)
        if (std::find(order.begin(), order.end(), axis) == order.end()) order.push_back(axis);
    std::vector<MatrixChoice> all = {MatrixChoice(matrix.axes.size(), 0)};
    for (const std::size_t axis : order) {
        std::vector<MatrixChoice> more;
        for (const MatrixChoice& choice : all)
            for (std::size_t value = 0; value < matrix.axes[axis].values.size(); ++value) {
                more.push_back(choice);
                more.back()[axis] = value;
            }
        all = std::move(more);
    }
    if (!matrix.listed.empty())
        eraseIf(all, [&](const MatrixChoice& choice) {
            return !anyOf(matrix.listed,
                          [&](const MatrixWhere& where) { return matches(where, choice); });
        });
    return all;
}

/// Few of the combinations that still have every pair of values that any of them has: again and
/// again the first of those that bring most new pairs.
std::vector<MatrixChoice> coverPairs(const std::vector<MatrixChoice>& all)
{
    using Pair = std::array<std::size_t, 4>;
    const auto pairsOf = [](const MatrixChoice& choice) {
        std::vector<Pair> pairs;
        for (std::size_t a = 0; a < choice.size(); ++a)
            for (std::size_t b = a + 1; b < choice.size(); ++b)
                pairs.push_back({a, choice[a], b, choice[b]});
        return pairs;
    };
    std::set<Pair> missing;
    for (const MatrixChoice& choice : all)
        for (const Pair& pair : pairsOf(choice)) missing.insert(pair);
    std::set<std::size_t> chosen;
    while (!missing.empty()) {
        std::size_t best = 0, most = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            std::size_t brings = 0;
            for (const Pair& pair : pairsOf(all[i])) brings += missing.count(pair);
            if (brings <= most) continue;
            most = brings;
            best = i;
        }
        chosen.insert(best);
        for (const Pair& pair : pairsOf(all[best])) missing.erase(pair);
    }
    std::vector<MatrixChoice> cover;
    for (const std::size_t i : chosen) cover.push_back(all[i]);
    return cover;
}

Diagnostic unused(std::string message, std::string help, const Place& place)
{
    return {Code::unused_name, std::move(message), std::move(help), place};
}

Diagnostics checkLayout(const Matrix& matrix)
{
    Diagnostics errors;
    std::set<std::size_t> used;
    std::map<std::string, std::string> files;
    std::vector<std::string> unchecked;
    const Place& configs = matrix.axes[kConfigAxis].values[0].place;
    for (const MatrixCell& cell : matrix.cells) {
        used.insert(cell.checks.begin(), cell.checks.end());
        if (cell.checks.empty()) unchecked.push_back(cell.name);
        const auto [known, is_new] = files.try_emplace(cell.file, cell.name);
        if (!is_new)
            errors.push_back(
                {Code::name_collision,
                 "the cells '" + known->second + "' and '" + cell.name +
                     "' would both have the file name '" + cell.file + "'",
                 "name their values by an object: \"cameras\": {\"left\": \"eye=...\"}", configs});
    }
    for (std::size_t i = 0; i < matrix.checks.size(); ++i)
        if (used.count(i) == 0)
            errors.push_back(unused("no cell matches this check",
                                    "change its `where`, or leave it out", matrix.checks[i].place));
    if (!unchecked.empty())
        errors.push_back(unused("cells without a check: " + std::to_string(unchecked.size()) +
                                    ", of which the first is '" + unchecked[0] + "'",
                                "add one whose `where` they match, such as {\"finite\": true}, or "
                                "leave them out of `cells`",
                                configs));
    return errors;
}

}  // namespace

MatrixChoice otherChoice(const MatrixCheck& check, MatrixChoice choice)
{
    for (const auto& [axis, values] : check.other) choice[axis] = *values.begin();
    return choice;
}

std::string cellName(const Matrix& matrix, const MatrixChoice& choice)
{
    return choiceName(matrix, choice, ", ", choice.size());
}

Diagnostics layOutCells(Matrix& matrix)
{
    std::vector<MatrixChoice> all = combinations(matrix);
    if (matrix.pairwise) all = coverPairs(all);
    for (const MatrixChoice& choice : all) {
        MatrixCell cell{choice, cellName(matrix, choice)};
        cell.file = fileName(choiceName(matrix, choice, "-", matrix.axes.size()));
        cell.approved = fileName(choiceName(matrix, choice, "-", kBackendAxis));
        for (std::size_t i = 0; i < matrix.checks.size(); ++i) {
            const MatrixCheck& check = matrix.checks[i];
            const bool itself = !check.other.empty() && otherChoice(check, choice) == choice;
            if (matches(check.where, choice) && !itself) cell.checks.push_back(i);
        }
        matrix.cells.push_back(std::move(cell));
    }
    return checkLayout(matrix);
}

}  // namespace crevice
