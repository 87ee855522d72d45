// SPDX-License-Identifier: MIT
#include "statistics/rank_correlation.h"

#include "base/check.h"
#include "statistics/ranks.h"

#include <cmath>

namespace planula {

std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b) {
    CHECK(a.size() == b.size(), a.size(), b.size());
    const Ranks of_a = ranks(a), of_b = ranks(b);
    const double middle = static_cast<double>(a.size() + 1) / 2;
    double both = 0, alone_a = 0, alone_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = of_a.of[i] - middle, y = of_b.of[i] - middle;
        both += x * y;
        alone_a += x * x;
        alone_b += y * y;
    }
    if (alone_a == 0 || alone_b == 0) return std::nullopt;
    return both / std::sqrt(alone_a * alone_b);
}

} // namespace planula
