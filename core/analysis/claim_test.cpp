// SPDX-License-Identifier: MIT
#include "analysis/claim_test.h"

#include "analysis/chance.h"
#include "base/text.h"
#include "statistics/bootstrap.h"
#include "statistics/counts.h"
#include "statistics/effect_size.h"
#include "statistics/rank_sum.h"
#include "statistics/summary.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

namespace planula {

namespace {

Resampling resampling(const Case &c) {
    return {c.analysis.confidence, c.analysis.resamples, bootstrap_seed("claim " + c.claim.id), 0};
}

// ---- Rank-sum tests ----

using Measure = std::function<double(const RunHistory &history, int generations)>;

std::vector<double> measure_all(const SettingRuns &setting, int generations, const Measure &measure) {
    std::vector<double> values;
    for (const RunHistory &history : setting.histories) values.push_back(measure(history, generations));
    return values;
}

Finding compare(const Case &c, const Measure &measure) {
    const std::vector<double> a = measure_all(*c.a, c.generations, measure);
    const std::vector<double> b = measure_all(*c.b, c.generations, measure);
    const double p = rank_sum(a, b).p, effect = a12(a, b);
    const Interval interval = bootstrap(a, b, a12, resampling(c));
    return {"A12",
            effect,
            interval.low,
            interval.high,
            p,
            rank_verdict(c.claim.expect, p, effect, interval.low, interval.high, c.analysis.significance)};
}

Finding best_at_generation(const Case &c) {
    return compare(c,
                   [](const RunHistory &history, int generations) { return history.best[generations - 1]; });
}

Finding size_entropy(const Case &c) {
    return compare(c,
                   [](const RunHistory &h, int generations) { return h.after.at(generations).size_entropy; });
}

Finding fitness_spread(const Case &c) {
    return compare(
        c, [](const RunHistory &h, int generations) { return h.after.at(generations).fitness_spread; });
}

Finding direction(const Case &c) {
    return compare(
        c, [](const RunHistory &h, int generations) { return h.after.at(generations).direction_resultant; });
}

Finding side_switches(const Case &c) {
    return compare(
        c, [](const RunHistory &h, int generations) { return h.after.at(generations).side_switches; });
}

// ---- Counts ----

/// Sums of the best fitness in each generation over the runs that a resample names.
std::vector<double> summed_curve(const SettingRuns &setting, std::span<const double> runs, int generations) {
    std::vector<double> sums(static_cast<std::size_t>(generations));
    for (const double run : runs) {
        const std::vector<double> &best = setting.histories[static_cast<std::size_t>(run)].best;
        for (int g = 0; g < generations; ++g) sums[g] += best[g];
    }
    return sums;
}

double share_ahead(const Case &c, std::span<const double> runs_a, std::span<const double> runs_b) {
    const std::vector<double> a = summed_curve(*c.a, runs_a, c.generations);
    const std::vector<double> b = summed_curve(*c.b, runs_b, c.generations);
    int ahead = 0;
    for (int g = 0; g < c.generations; ++g)
        ahead += a[g] / static_cast<double>(runs_a.size()) >= b[g] / static_cast<double>(runs_b.size());
    return static_cast<double>(ahead) / c.generations;
}

Finding mean_ahead(const Case &c) {
    // The bootstrap draws whole runs: its values are their places.
    std::vector<double> a(c.a->runs.size()), b(c.b->runs.size());
    std::iota(a.begin(), a.end(), 0.0);
    std::iota(b.begin(), b.end(), 0.0);
    const double share = share_ahead(c, a, b);
    const auto statistic = [&](std::span<const double> x, std::span<const double> y) {
        return share_ahead(c, x, y);
    };
    const Interval interval = bootstrap(a, b, statistic, resampling(c));
    const char *verdict = share >= c.claim.level          ? "reproduced"
                          : interval.high < c.claim.level ? "contradicted"
                                                          : "inconclusive";
    return {"share of generations ahead", share, interval.low, interval.high, std::nullopt, verdict};
}

/// A run among those of both settings.
struct Contender {
    double fitness, elongation;
    bool of_a;
};

/// The champions of both settings, best first; of equals those of b come first, which speaks against the
/// claim.
std::vector<Contender> contenders(const Case &c) {
    std::vector<Contender> all;
    for (const SettingRuns *setting : {c.b, c.a})
        for (const RunHistory &history : setting->histories) {
            const ChampionRow &champion = history.after.at(c.generations).champion;
            all.push_back({champion.fitness, champion.elongation, setting == c.a});
        }
    std::stable_sort(all.begin(), all.end(),
                     [](const Contender &x, const Contender &y) { return x.fitness > y.fitness; });
    return all;
}

Finding top_runs(const Case &c) {
    const std::vector<Contender> all = contenders(c);
    const int total = static_cast<int>(all.size()), count = std::min(c.claim.count, total);
    const auto found = static_cast<int>(
        std::count_if(all.begin(), all.begin() + count, [](const Contender &x) { return x.of_a; }));
    const double p = hypergeometric_tail(found, total, static_cast<int>(c.a->runs.size()), count);
    return {"a's runs among the best " + to_text(c.claim.count),
            found,
            std::nullopt,
            std::nullopt,
            p,
            top_verdict(found, c.claim.count)};
}

Finding elongated(const Case &c) {
    const std::vector<Contender> all = contenders(c);
    const auto count = std::min(static_cast<std::size_t>(c.claim.count), all.size());
    std::vector<double> top, rest;
    for (std::size_t i = 0; i < all.size(); ++i) (i < count ? top : rest).push_back(all[i].elongation);
    const std::string name = "a's and elongated among the best " + to_text(c.claim.count);
    if (rest.empty()) return {name, std::nullopt, std::nullopt, std::nullopt, std::nullopt, "inconclusive"};

    const double usual = median(rest);
    const auto found =
        static_cast<int>(std::count_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count),
                                       [&](const Contender &x) { return x.of_a && x.elongation > usual; }));
    return {
        name, found, std::nullopt, std::nullopt, rank_sum(top, rest).p, top_verdict(found, c.claim.count)};
}

Finding cyclic(const Case &c) {
    // Who falls over once makes no way late, who contracts once and glides no movement of its own.
    int found = 0;
    for (const RunHistory &history : c.a->histories) {
        const ChampionRow &champion = history.after.at(c.generations).champion;
        found += std::min(champion.late_share, champion.late_actuation) < c.claim.level;
    }

    // The original's runs and ours together: how often would chance give ours so many?
    const int ours = static_cast<int>(c.a->runs.size()), original = c.analysis.design.seeds;
    const int stuck = found + std::min(c.claim.count, original);
    const double p = hypergeometric_tail(found, ours + original, stuck, ours);
    const char *verdict = found <= c.claim.count        ? "reproduced"
                          : p < c.analysis.significance ? "contradicted"
                                                        : "inconclusive";
    return {"runs without a lasting gait", found, std::nullopt, std::nullopt, p, verdict};
}

// ---- The list of tests ----

constexpr std::array tests{
    ClaimTest{"best_at_generation", ClaimTest::ranks, best_at_generation},
    ClaimTest{"mean_ahead", ClaimTest::level_of_two, mean_ahead},
    ClaimTest{"top_runs", ClaimTest::count_of_two, top_runs},
    ClaimTest{"size_entropy", ClaimTest::ranks, size_entropy},
    ClaimTest{"fitness_spread", ClaimTest::ranks, fitness_spread},
    ClaimTest{"direction", ClaimTest::ranks, direction},
    ClaimTest{"side_switches", ClaimTest::ranks, side_switches},
    ClaimTest{"cyclic", ClaimTest::count_of_one, cyclic},
    ClaimTest{"elongated", ClaimTest::count_of_two, elongated},
};

constexpr auto names = [] {
    std::array<std::string_view, tests.size()> list;
    std::transform(tests.begin(), tests.end(), list.begin(), [](const ClaimTest &test) { return test.name; });
    return list;
}();

} // namespace

std::span<const std::string_view> claim_tests() { return names; }

const ClaimTest *find_test(std::string_view name) {
    const auto found =
        std::find_if(tests.begin(), tests.end(), [&](const ClaimTest &test) { return test.name == name; });
    return found == tests.end() ? nullptr : &*found;
}

std::string rank_verdict(std::string_view expect, double p, double effect, double low, double high,
                         double significance) {
    constexpr double even = 0.5;
    const bool differs = p < significance, around = low <= even && even <= high;
    if (expect == "no_difference") {
        if (differs != around) return differs ? "contradicted" : "reproduced";
        return "inconclusive";
    }
    if (!differs || effect == even) return "inconclusive";
    return (effect > even) == (expect == "greater") ? "reproduced" : "contradicted";
}

std::string top_verdict(int found, int count) {
    if (found == count) return "reproduced";
    return 2 * found < count ? "contradicted" : "inconclusive";
}

} // namespace planula
