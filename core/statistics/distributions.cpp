// SPDX-License-Identifier: MIT
#include "statistics/distributions.h"

#include "base/math.h"
#include "statistics/demand.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planula {

namespace {

/// The beta function B(freedom / 2, 1/2), by the recurrence B(a + 1, b) = B(a, b) a / (a + b).
double beta_of_half(int freedom) {
    double a = freedom % 2 == 1 ? 0.5 : 1, beta = freedom % 2 == 1 ? math::pi : 2;
    for (; a < 0.5 * freedom; a += 1) beta *= a / (a + 0.5);
    return beta;
}

/// The regularised incomplete beta function I_x(a, b), of positive terms (Abramowitz & Stegun 1964, 26.5.4).
double incomplete_beta(double x, double a, double b, double beta) {
    double term = math::pow(x, a) * math::pow(1 - x, b) / (a * beta), sum = 0;
    for (double n = 0; sum + term > sum; n += 1) {
        sum += term;
        term *= x * (a + b + n) / (a + 1 + n);
    }
    return sum;
}

} // namespace

double normal_below(double z) { return 0.5 * math::erfc(-z / std::sqrt(2.0)); }

double normal_quantile(double p) {
    demand(p > 0 && p < 1, "a quantile of the normal distribution is asked at a probability between 0 and 1",
           p);
    if (p > 0.5) return -normal_quantile(1 - p);
    double low = -40, high = 0; // no p is so small that it lies below
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (normal_below(middle) < p ? low : high) = middle;
    }
    return high;
}

double student_beyond(double t, int freedom) {
    demand(freedom >= 1, "Student's t has at least 1 degree of freedom", freedom);
    if (t == 0) return 1;
    if (std::isinf(t)) return 0;
    const double a = 0.5 * freedom, beta = beta_of_half(freedom), square = t * t;
    // The series for the smaller of the two parts converges quickly.
    if (square < 2) return 1 - incomplete_beta(square / (freedom + square), 0.5, a, beta);
    return incomplete_beta(freedom / (freedom + square), a, 0.5, beta);
}

std::vector<double> ways_to_sum(const std::vector<std::size_t> &ranks, std::size_t m) {
    const std::size_t largest =
        std::accumulate(ranks.end() - static_cast<std::ptrdiff_t>(m), ranks.end(), std::size_t{0});
    std::vector<std::vector<double>> ways(m + 1, std::vector<double>(largest + 1));
    ways[0][0] = 1;
    // One rank after the other is chosen or not; the i chosen are at most this one.
    for (const std::size_t rank : ranks)
        for (std::size_t i = m; i >= 1; --i)
            for (std::size_t sum = std::min(i * rank, largest); sum >= rank; --sum)
                ways[i][sum] += ways[i - 1][sum - rank];
    return ways[m];
}

std::vector<double> chances_of_signed_sums(const std::vector<std::size_t> &ranks) {
    std::vector<double> chance(std::accumulate(ranks.begin(), ranks.end(), std::size_t{0}) + 1);
    chance[0] = 1;
    for (const std::size_t rank : ranks)
        for (std::size_t sum = chance.size(); sum-- > 0;)
            chance[sum] = 0.5 * (chance[sum] + (sum >= rank ? chance[sum - rank] : 0));
    return chance;
}

} // namespace planula
