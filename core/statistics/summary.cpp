// SPDX-License-Identifier: MIT
#include "statistics/summary.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace planula {

void check_sample(std::span<const double> sample) {
    CHECK(!sample.empty());
    for (const double value : sample) CHECK(std::isfinite(value), value);
}

double mean(std::span<const double> sample) {
    check_sample(sample);
    return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

double quantile(std::span<const double> sample, double probability) {
    check_sample(sample);
    CHECK(probability >= 0 && probability <= 1, probability);

    // The place among the sorted values, counted from 0, falls between `below` and the next.
    const double place = probability * static_cast<double>(sample.size() - 1);
    const double below = std::floor(place);
    std::vector<double> values(sample.begin(), sample.end());
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(below);
    std::nth_element(values.begin(), low, values.end());
    if (place == below) return *low;
    const double high = *std::min_element(low + 1, values.end());
    return *low + (place - below) * (high - *low);
}

double median(std::span<const double> sample) { return quantile(sample, 0.5); }

} // namespace planula
