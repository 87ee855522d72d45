// SPDX-License-Identifier: MIT
#include "statistics/summary.h"

#include "statistics/demand.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace planula {

void check_sample(std::span<const double> sample) {
    if (sample.empty()) throw InputError("a sample has at least one value: this one is empty");
    for (std::size_t i = 0; i < sample.size(); ++i)
        if (!std::isfinite(sample[i]))
            throw InputError("the values of a sample are finite numbers: value " +
                             to_text(static_cast<std::int64_t>(i + 1)) + " of " +
                             to_text(static_cast<std::int64_t>(sample.size())) + " is " + to_text(sample[i]));
}

void check_pairs(std::span<const double> a, std::span<const double> b) {
    check_sample(a);
    check_sample(b);
    if (a.size() != b.size())
        throw InputError("pairs need two samples of the same size: these have " +
                         to_text(static_cast<std::int64_t>(a.size())) + " and " +
                         to_text(static_cast<std::int64_t>(b.size())) + " values");
}

double mean(std::span<const double> sample) {
    check_sample(sample);
    return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

double quantile(std::span<const double> sample, double probability) {
    check_sample(sample);
    demand(probability >= 0 && probability <= 1, "a quantile is asked at a probability from 0 to 1",
           probability);

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
