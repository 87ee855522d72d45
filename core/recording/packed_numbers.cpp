// SPDX-License-Identifier: MIT
#include "recording/packed_numbers.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace planula {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr int bits = 5; // of a number in a character
constexpr std::uint64_t more = std::uint64_t{1} << bits;

void pack(std::int64_t number, std::string &text) {
    const std::uint64_t magnitude = static_cast<std::uint64_t>(number < 0 ? -number : number);
    std::uint64_t rest = magnitude << 1 | (number < 0 ? 1 : 0);
    do {
        const std::uint64_t digit = rest % more;
        rest >>= bits;
        text += alphabet[digit | (rest ? more : 0)];
    } while (rest);
}

} // namespace

std::int64_t quantised(double value, double scale) {
    constexpr double most = 0x1p50;
    if (std::isnan(value)) return 0;
    return static_cast<std::int64_t>(std::floor(std::clamp(value * scale, -most, most) + 0.5));
}

void pack_series(std::span<const std::int64_t> series, int order, std::string &text) {
    std::vector<std::int64_t> numbers(series.begin(), series.end());
    for (int i = 0; i < order; ++i)
        for (std::size_t at = numbers.size(); at-- > 1;) numbers[at] -= numbers[at - 1];
    for (const std::int64_t number : numbers) pack(number, text);
}

} // namespace planula
