// SPDX-License-Identifier: MIT
// The checks of a matrix file.
#include "tools/measure/matrix/read_json.h"

#include "core/base/text.h"
#include "tools/measure/reference/tracer.h"

#include <cmath>

namespace crevice {
namespace {

constexpr double kNoLimit = INFINITY;

struct NumberKey {
    const char* name;
    double least, most;
    double value;  ///< Without it: NaN where it must be there, kNoLimit where nothing is then set.
    bool whole = false;
};

/// The kinds of checks by CheckKind, and what stands in each.
const struct KindKey {
    const char* name;
    enum Shape { object, yes, number, pair } shape;
    std::vector<NumberKey> numbers;
    const char* other;  ///< The key that names another cell; null for none.
    const char* help;
} kKinds[] = {
    {"approved",
     KindKey::object,
     {{"max", 0, 1, kNoLimit}, {"share", 0, 1, 0}, {"flip", 0, 1, kNoLimit}},
     nullptr,
     "write {\"approved\": {\"max\": 0.01, \"share\": 0.001}} or {\"approved\": {\"flip\": 0.02}}"},
    {"truth",
     KindKey::object,
     {{"rmse", 0, 1, kNoLimit}, {"bias", 0, 1, kNoLimit}, {"rays", 1, kMaxTraceRays, 64, true}},
     nullptr,
     "write {\"truth\": {\"rmse\": 0.08, \"bias\": 0.02}}"},
    {"same",
     KindKey::object,
     {{"max", 0, 1, 0}, {"share", 0, 1, 0}},
     "as",
     "write {\"same\": {\"as\": {\"backend\": \"egl\"}, \"max\": 0.01}}"},
    {"plan", KindKey::yes, {}, nullptr, "write {\"plan\": true}"},
    {"time",
     KindKey::object,
     {{"most", 0, 1e6, NAN}},
     "over",
     "write {\"time\": {\"over\": {\"config\": \"learnopengl\"}, \"most\": 1.5}}"},
    {"finite", KindKey::yes, {}, nullptr, "write {\"finite\": true}"},
    {"range",
     KindKey::pair,
     {{"low", -1e30, 1e30, NAN}, {"high", -1e30, 1e30, NAN}},
     nullptr,
     "write {\"range\": [0, 1]}"},
    {"background",
     KindKey::number,
     {{"value", -1e30, 1e30, NAN}},
     nullptr,
     "write {\"background\": 1}"},
    {"open",
     KindKey::object,
     {{"least", 0, 1, NAN}, {"share", 0, 1, 0}, {"rays", 1, kMaxTraceRays, 64, true}},
     nullptr,
     "write {\"open\": {\"least\": 0.9, \"share\": 0.01}}"}};

std::vector<std::string> kindNames()
{
    return namesOf(std::vector<KindKey>(std::begin(kKinds), std::end(kKinds)));
}

std::vector<std::string> keysOf(const KindKey& kind)
{
    std::vector<std::string> keys = namesOf(kind.numbers);
    if (kind.other) keys.insert(keys.begin(), kind.other);
    return keys;
}

std::vector<std::string> keysOfChecks()
{
    std::vector<std::string> keys = kindNames();
    keys.insert(keys.end(), {"where", "output"});
    return keys;
}

class CheckReader {
public:
    explicit CheckReader(MatrixJson& json) : json_(json) {}

    void readAll(const Node& document)
    {
        const Node* checks = json_.ofKind(document, "checks", Node::Kind::array);
        if (!document.find("checks") || (checks && checks->items.empty()))
            json_.fail(checks ? checks->place : document.place, Code::missing_key,
                       "the matrix file has no 'checks'", "write \"checks\": [{\"finite\": true}]");
        if (!checks) return;
        for (const Node& item : checks->items) readCheck(item);
    }

private:
    void readCheck(const Node& node)
    {
        if (node.kind != Node::Kind::object)
            return json_.wrongType(node, "a check", "an object", "write {\"finite\": true}");
        json_.onlyKeys(node, keysOfChecks(), "a check");
        const Member* kind = nullptr;
        int kinds = 0;
        for (const Member& member : node.members)
            if (contains(kindNames(), member.key)) kind = &member, ++kinds;
        if (kinds != 1)
            return json_.fail(node.place, kinds ? Code::name_collision : Code::missing_key,
                              kinds ? "a check has two kinds" : "a check has no kind",
                              "give it one of " + joined(kindNames()));
        MatrixCheck check;
        check.place = kind->key_place;
        check.text = toJson(node);
        check.kind = static_cast<CheckKind>(
            std::find_if(std::begin(kKinds), std::end(kKinds),
                         [&](const KindKey& each) { return each.name == kind->key; }) -
            kKinds);
        if (const Node* output = json_.ofKind(node, "output", Node::Kind::string))
            check.output = output->text;
        if (check.kind == CheckKind::plan && !node.find("output")) check.output.clear();  // all
        if (const Node* where = node.find("where")) check.where = json_.readWhere(*where, "where");
        readKind(kind->value, kKinds[static_cast<int>(check.kind)], check);
        json_.matrix.checks.push_back(std::move(check));
    }

    void readKind(const Node& node, const KindKey& kind, MatrixCheck& check)
    {
        const std::string what = std::string("'") + kind.name + "'";
        switch (kind.shape) {
        case KindKey::yes:
            if (!node.boolean) json_.wrongType(node, what, "true", kind.help);
            return;
        case KindKey::number: return readNumber(node, kind, kind.numbers[0], check);
        case KindKey::pair:
            if (node.kind != Node::Kind::array || node.items.size() != 2)
                return json_.wrongType(node, what, "a list of two numbers", kind.help);
            for (std::size_t i = 0; i < 2; ++i)
                readNumber(node.items[i], kind, kind.numbers[i], check);
            if (check.has("low") && check.has("high") && !(check["low"] <= check["high"]))
                json_.fail(node.place, Code::bad_range, "the range's low is above its high",
                           kind.help);
            return;
        case KindKey::object:
            if (node.kind != Node::Kind::object)
                return json_.wrongType(node, what, "an object", kind.help);
            readObject(node, kind, check);
        }
    }

    void readObject(const Node& node, const KindKey& kind, MatrixCheck& check)
    {
        json_.onlyKeys(node, keysOf(kind), std::string("'") + kind.name + "'");
        bool limits = false, limited = false;  // could have limits that may be left out; has one
        for (const NumberKey& key : kind.numbers) {
            const Node* number = node.find(key.name);
            limits |= key.value == kNoLimit;
            limited |= number && key.value == kNoLimit;
            if (number)
                readNumber(*number, kind, key, check);
            else if (std::isnan(key.value))
                json_.fail(node.place, Code::missing_key,
                           std::string("'") + kind.name + "' has no '" + key.name + "'", kind.help);
            else if (key.value != kNoLimit)
                check.numbers[key.name] = key.value;
        }
        if (limits && !limited)
            json_.fail(node.place, Code::missing_key,
                       std::string("'") + kind.name + "' sets no limit", kind.help);
        if (kind.other) readOther(node, kind, check);
    }

    void readNumber(const Node& node, const KindKey& kind, const NumberKey& key, MatrixCheck& check)
    {
        const std::string what = std::string("'") + kind.name + "' " + key.name;
        if (node.kind != Node::Kind::number || (key.whole && !node.integer()))
            return json_.wrongType(node, what, key.whole ? "a whole number" : "a number",
                                   kind.help);
        if (!(node.number >= key.least && node.number <= key.most))
            json_.fail(node.place, Code::out_of_range,
                       what + " " + brief(node) + " is outside [" + shortest(key.least) + ", " +
                           shortest(key.most) + "]",
                       kind.help);
        check.numbers[key.name] = node.number;
    }

    void readOther(const Node& node, const KindKey& kind, MatrixCheck& check)
    {
        const Node* other = node.find(kind.other);
        if (!other)
            return json_.fail(node.place, Code::missing_key,
                              std::string("'") + kind.name + "' has no '" + kind.other + "'",
                              kind.help);
        check.other = json_.readWhere(*other, kind.other);
        if (anyOf(check.other, [](const auto& each) { return each.second.size() > 1; }))
            json_.fail(other->place, Code::bad_length,
                       std::string("'") + kind.other + "' names several values of one axis",
                       "name one cell");
        const bool resized = check.other.count(kSizeAxis) > 0;
        if (resized && check.kind == CheckKind::same)
            json_.fail(other->place, Code::reference_missing,
                       "pictures of two sizes cannot be the same", "compare cells of one size");
    }

    MatrixJson& json_;
};

}  // namespace

std::string MatrixCheck::title() const
{
    const std::string name = kKinds[static_cast<int>(kind)].name;
    return output.empty() ? name : name + " " + output;
}

void readChecks(MatrixJson& json, const Node& document) { CheckReader(json).readAll(document); }

std::vector<MatrixKey> checkKeys()
{
    std::vector<MatrixKey> all;
    for (const std::string& key : keysOfChecks()) all.push_back({"checks", key});
    for (const KindKey& kind : kKinds)
        if (kind.shape == KindKey::object)
            for (const std::string& key : keysOf(kind)) all.push_back({kind.name, key});
    return all;
}

}  // namespace crevice
