// SPDX-License-Identifier: MIT
#include "statement/problems.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>

namespace planula {

namespace {

Place step_to(const Place &from, Step step, std::string words, const Value *value) {
    // A table with a line of its own may be part of several settings: its errors are those of one table.
    if (value && value->site.line > 0)
        return {value->site, {}, step.key.empty() ? std::move(words) : step.key};
    Place place{from.site, from.path, std::move(words)};
    place.path.push_back(std::move(step));
    return place;
}

} // namespace

Place Place::at(const std::string &key, const Value *value) const {
    return step_to(*this, {key, 0}, words.empty() ? key : words + "." + key, value);
}

Place Place::at(int index, const Value *value) const {
    return step_to(*this, {"", index}, words + "[" + to_text(index) + "]", value);
}

Place Problems::root(const Value &result, const Source &script) const {
    if (result.site.line > 0) return {result.site, {}, ""};
    return {{script.name, line_of_return(script.tokens)}, {}, ""};
}

std::string Problems::line_of(const Place &place) const {
    const Source *source = sources_.named(place.site.source);
    const int line = source ? line_of_entry(source->tokens, place.site.line, place.path) : place.site.line;
    return place.site.source + ":" + to_text(line);
}

void Problems::add(const Place &place, const std::string &message) {
    if (!is_full()) add(line_of(place) + ": " + message);
}

void Problems::add(const std::string &message) {
    constexpr std::size_t longest = 4000; // a script may state texts of megabytes
    const std::string shown = message.size() > longest ? message.substr(0, longest) + "…" : message;
    if (!is_full() && std::find(messages_.begin(), messages_.end(), shown) == messages_.end())
        messages_.push_back(shown);
}

void Problems::raise() const {
    std::string all;
    for (const std::string &message : messages_) all += (all.empty() ? "" : "\n") + message;
    if (is_full())
        all += "\nthese are the first " + to_text(static_cast<int>(most)) + " problems; there may be more";
    if (!all.empty()) throw InputError(all);
}

} // namespace planula
