// SPDX-License-Identifier: MIT
#include "analysis/chance.h"

#include "base/check.h"
#include "base/hash.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace planula {

double hypergeometric_tail(int marked, int total, int all_marked, int drawn) {
    CHECK(drawn >= 0 && drawn <= total && all_marked >= 0 && all_marked <= total, total, all_marked, drawn);
    // Drawn one by one: chance[j] is that of j marked ones so far.
    std::vector<double> chance(static_cast<std::size_t>(drawn) + 1);
    chance[0] = 1;
    for (int i = 0; i < drawn; ++i)
        for (int j = i; j >= 0; --j) {
            const double marked_next = std::max(0, all_marked - j), left = total - i;
            chance[j + 1] += chance[j] * marked_next / left;
            chance[j] *= std::max(0.0, left - marked_next) / left;
        }
    double tail = 0;
    for (int j = drawn; j >= std::max(marked, 0); --j) tail += chance[j];
    return std::min(tail, 1.0);
}

std::uint64_t bootstrap_seed(std::string_view what) {
    constexpr std::size_t digits = 16;
    const std::string hex = sha256(what).substr(0, digits);
    std::uint64_t seed = 0;
    std::from_chars(hex.data(), hex.data() + digits, seed, 16);
    return seed;
}

} // namespace planula
