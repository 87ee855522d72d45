// SPDX-License-Identifier: MIT
// Numbers as text, without locale: the shortest decimal that reads back to the same bits. Names that are near others.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace planula {

std::string to_text(double value);
std::string to_text(std::int64_t value);
inline std::string to_text(int value) { return to_text(static_cast<std::int64_t>(value)); }
/// Fixed notation with `decimals` digits after the point, for people; not meant to be read back.
std::string to_fixed(double value, int decimals);

/// A whole number with its noun in the singular or plural: "1 run", "2 runs".
template <class Count> std::string counted(Count count, std::string_view noun) {
    return to_text(static_cast<std::int64_t>(count)).append(" ").append(noun).append(count == 1 ? "" : "s");
}

/// The whole text as a number; nothing if any character is left over or the value is out of range.
std::optional<double> parse_double(std::string_view text);
std::optional<std::int64_t> parse_int(std::string_view text);

/// The candidate nearest to `word` by edit distance, or "" if none is within half its length.
template <class Names> std::string nearest_name(std::string_view word, const Names &candidates);
std::size_t edit_distance(std::string_view a, std::string_view b);

template <class Names> std::string nearest_name(std::string_view word, const Names &candidates) {
    std::string best;
    std::size_t least = word.size() / 2 + 1;
    for (const auto &candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) least = distance, best = candidate;
    }
    return best;
}

/// "; did you mean 'x'?" of the nearest name, or "".
template <class Names> std::string suggestion(std::string_view word, const Names &candidates) {
    const std::string nearest = nearest_name(word, candidates);
    return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

/// "a, b, c".
template <class Names> std::string list_of(const Names &names) {
    std::string list;
    for (const auto &name : names) list.append(list.empty() ? "" : ", ").append(name);
    return list;
}

} // namespace planula
