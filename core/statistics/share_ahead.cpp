// SPDX-License-Identifier: MIT
#include "statistics/share_ahead.h"

#include "base/error.h"
#include "base/text.h"

#include <vector>

namespace planula {

namespace {

/// Sums over the curves, place by place.
std::vector<double> sums_of(std::span<const Curve> curves, std::size_t places) {
    std::vector<double> sums(places);
    for (const Curve curve : curves) {
        if (curve.size() != places)
            throw InputError("curves must have the same number of values: these have " +
                             to_text(static_cast<std::int64_t>(places)) + " and " +
                             to_text(static_cast<std::int64_t>(curve.size())));
        for (std::size_t i = 0; i < places; ++i) sums[i] += curve[i];
    }
    return sums;
}

} // namespace

double share_ahead(std::span<const Curve> a, std::span<const Curve> b) {
    if (a.empty() || b.empty() || a.front().empty())
        throw InputError("a share of places ahead needs a curve of each side, of at least one value");
    const std::vector<double> sums_a = sums_of(a, a.front().size()), sums_b = sums_of(b, a.front().size());
    const double runs_a = static_cast<double>(a.size()), runs_b = static_cast<double>(b.size());
    int ahead = 0;
    for (std::size_t i = 0; i < sums_a.size(); ++i) ahead += sums_a[i] / runs_a >= sums_b[i] / runs_b;
    return static_cast<double>(ahead) / static_cast<double>(sums_a.size());
}

} // namespace planula
