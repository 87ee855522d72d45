// SPDX-License-Identifier: MIT
// The text of a recording read back, as far as tests need it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace planula::test {

/// The numbers of a text in Base64 VLQ, as they stand.
inline std::vector<std::int64_t> unpack_numbers(std::string_view text) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::int64_t> numbers;
    std::uint64_t rest = 0;
    int place = 0;
    for (const char letter : text) {
        const std::size_t digit = letters.find(letter);
        if (digit == letters.npos) throw std::runtime_error("no character of Base64");
        rest |= (digit % 32) << place;
        place += 5;
        if (digit >= 32) continue;
        const auto magnitude = static_cast<std::int64_t>(rest >> 1);
        numbers.push_back(rest % 2 ? -magnitude : magnitude);
        rest = 0, place = 0;
    }
    return numbers;
}

/// The series whose differences of some order these are.
inline std::vector<std::int64_t> summed(std::vector<std::int64_t> series, int order) {
    for (int i = 0; i < order; ++i)
        for (std::size_t at = 1; at < series.size(); ++at) series[at] += series[at - 1];
    return series;
}

/// The text of the member that this name has first in a JSON text, up to its end: a text without its quotes, a list
/// with its brackets, or a number.
inline std::string member(const std::string &json, const std::string &name) {
    const std::string key = "\"" + name + "\":";
    std::size_t at = json.find(key);
    if (at == json.npos) throw std::runtime_error("no member " + name);
    at += key.size();
    if (json[at] == '"') return json.substr(at + 1, json.find('"', at + 1) - at - 1);
    std::size_t end = at;
    for (int depth = 0; end < json.size(); ++end) {
        const char letter = json[end];
        if (letter == '[' || letter == '{') ++depth;
        if ((letter == ',' && depth == 0) || ((letter == ']' || letter == '}') && --depth < 0)) break;
    }
    return json.substr(at, end - at);
}

} // namespace planula::test
