// SPDX-License-Identifier: MIT
#include "evaluation/rhythm.h"

#include "base/math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace planula {

namespace {

/// The least share of the highest peak at which an earlier one is the period: the highest may be a multiple of it.
constexpr double first_peak_share = 0.9;

/// The mean signal of each cell.
std::vector<double> means_of(std::span<const std::vector<double>> signals) {
    std::vector<double> means(signals.front().size());
    for (const std::vector<double> &sample : signals)
        for (std::size_t cell = 0; cell < means.size(); ++cell) means[cell] += sample[cell];
    for (double &mean : means) mean /= static_cast<double>(signals.size());
    return means;
}

/// Signals less their means.
Samples centred(std::span<const std::vector<double>> signals) {
    const std::vector<double> means = means_of(signals);
    Samples result(signals.begin(), signals.end());
    for (std::vector<double> &sample : result)
        for (std::size_t cell = 0; cell < means.size(); ++cell) sample[cell] -= means[cell];
    return result;
}

double product(const std::vector<double> &a, const std::vector<double> &b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// The correlation at each lag from 0 to half the time, in [-1, 1].
std::vector<double> correlations(const Samples &signals) {
    const std::size_t count = signals.size();
    std::vector<double> result;
    for (std::size_t lag = 0; lag <= count / 2; ++lag) {
        double both = 0, early = 0, late = 0;
        for (std::size_t i = 0; i + lag < count; ++i) {
            both += product(signals[i], signals[i + lag]);
            early += product(signals[i], signals[i]);
            late += product(signals[i + lag], signals[i + lag]);
        }
        const double scale = std::sqrt(early * late);
        result.push_back(scale > 0 ? both / scale : 0);
    }
    return result;
}

/// Where a parabola through the values at lag - 1, lag and lag + 1, a peak, is highest.
double summit(const std::vector<double> &values, std::size_t lag) {
    const double before = values[lag - 1], at = values[lag], after = values[lag + 1];
    const double bend = before - 2 * at + after;
    return static_cast<double>(lag) + (bend < 0 ? 0.5 * (before - after) / bend : 0);
}

} // namespace

double period_of(std::span<const std::vector<double>> signals) {
    if (signals.size() < 4) return 0;
    const std::vector<double> values = correlations(centred(signals));
    std::vector<std::size_t> peaks;
    double highest = 0;
    for (std::size_t lag = 2; lag + 1 < values.size(); ++lag)
        if (values[lag] > values[lag - 1] && values[lag] >= values[lag + 1] && values[lag] >= rhythm_level) {
            peaks.push_back(lag);
            highest = std::max(highest, values[lag]);
        }
    for (const std::size_t lag : peaks)
        if (values[lag] >= first_peak_share * highest) return summit(values, lag);
    return 0;
}

std::vector<double> phases_of(std::span<const std::vector<double>> signals, double period) {
    const double periods = std::floor(static_cast<double>(signals.size()) / period);
    const auto length = static_cast<std::size_t>(std::lround(periods * period));
    const Samples whole = centred(signals.last(std::min(length, signals.size())));
    std::vector<double> phases;
    for (std::size_t cell = 0; cell < whole.front().size(); ++cell) {
        double sine = 0, cosine = 0;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const double angle = 2 * math::pi * static_cast<double>(i) / period;
            sine += whole[i][cell] * math::sin(angle);
            cosine += whole[i][cell] * math::cos(angle);
        }
        // cos(angle + φ) has the components cos φ and -sin φ.
        phases.push_back(math::atan2(-sine, cosine) / (2 * math::pi));
    }
    const double first = phases.front();
    for (double &phase : phases) phase -= first + std::round(phase - first);
    return phases;
}

} // namespace planula
