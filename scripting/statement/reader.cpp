// SPDX-License-Identifier: MIT
#include "statement/reader.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planula {

namespace {

/// What to write instead of an unknown key: a name that differs by one letter, or else the table that has the key.
std::string advice(const std::string &key, const Value &stated, const Keys &keys) {
    const std::vector<std::string_view> names = keys.names();
    const std::string nearest = nearest_name(key, names);
    const bool one_letter = !nearest.empty() && edit_distance(key, nearest) == 1;
    const std::string elsewhere = one_letter ? "" : where_it_belongs(key, stated, keys);
    return elsewhere.empty() ? suggestion(key, names) : "; " + elsewhere;
}

} // namespace

Reader::Reader(const Value &table, Place place, Keys keys, Problems &problems, bool list)
    : table_(table), place_(std::move(place)), keys_(std::move(keys)), problems_(problems) {
    const std::string owner = place_.words.empty() ? "the experiment" : place_.words;
    const std::vector<std::string_view> names = keys_.names();
    for (const auto &[key, value] : table_.fields)
        if (!keys_.find(key) && !problems_.is_full())
            problems_.add(place_.at(key), owner + " has no '" + key + "'" + advice(key, value, keys_) +
                                              " (allowed: " + list_of(names) + ")");
    if (!list && !table_.list.empty())
        problems_.add(place_.at(1), owner + " has a value without a name; write: name = value");
}

const Value *Reader::field(const std::string &key, Value::Kind kind, bool needed) {
    const Key *row = keys_.find(key);
    CHECK(row && row->needed() == needed, key);
    const Value *value = table_.find(key);
    const std::string words = place_.words.empty() ? key : place_.words + "." + key;
    if (!value) {
        if (needed) problems_.add(place_, words + " is missing");
        return nullptr;
    }
    if (value->is(kind)) return value;
    report(key, words + " must be " + name_of(kind) + ", not " + name_of(value->kind));
    return nullptr;
}

std::string Reader::text(const std::string &key, bool needed) {
    const Value *value = field(key, Value::Kind::text, needed);
    if (!value) return "";
    if (value->text.find_first_of(std::string_view("\r\n\0", 3)) == std::string::npos) return value->text;
    report(key, at(key).words + " must be one line, without a line break or a zero byte");
    return "";
}

std::optional<double> Reader::number(const std::string &key, bool needed) {
    const Value *value = field(key, Value::Kind::number, needed);
    if (!value) return std::nullopt;
    if (std::isfinite(value->number)) return value->number;
    report(key, at(key).words + " must be a finite number");
    return std::nullopt;
}

int Reader::whole(const std::string &key, bool needed) {
    const std::optional<double> value = number(key, needed);
    if (!value) return 0;
    if (*value >= 0 && *value <= std::numeric_limits<int>::max() && *value == std::trunc(*value))
        return static_cast<int>(*value);
    report(key, at(key).words + " = " + to_text(*value) + " must be a whole number, 0 or more");
    return 0;
}

std::optional<double> Reader::quantity(const std::string &key, const Parameters &parameters, bool needed) {
    const Value *value = table_.find(key);
    if (!value || !value->is(Value::Kind::text)) return number(key, needed);
    std::optional<double> result;
    check_at(at(key), problems_, [&] {
        if (parameter_row(value->text).is_choice())
            throw InputError(at(key).words + ": " + value->text + " is a choice, not a number");
        result = parameter(parameters, value->text);
    });
    return result;
}

void check_at(const Place &place, Problems &problems, const std::function<void()> &check) {
    if (problems.is_full()) return;
    try {
        check();
    } catch (const InputError &error) {
        problems.add(place, error.what());
    }
}

std::string not_one_of(std::string_view word, std::span<const std::string_view> names) {
    return "'" + std::string(word) + "' is not one of " + list_of(names) + suggestion(word, names);
}

} // namespace planula
