// SPDX-License-Identifier: MIT
#include "analysis/claim_test.h"

#include "analysis/chance.h"
#include "base/text.h"
#include "evaluation/cyclic_gait.h"
#include "statistics/bootstrap.h"
#include "statistics/counts.h"
#include "statistics/effect_size.h"
#include "statistics/equivalence.h"
#include "statistics/permutation.h"
#include "statistics/rank_sum.h"
#include "statistics/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace planula {

namespace {

std::uint64_t seed_of(const Case &c) { return bootstrap_seed("claim " + c.claim.id); }

/// A bootstrap interval of the statistic; none if there are too few runs.
void add_interval(const Case &c, std::span<const double> a, std::span<const double> b,
                  const TwoSampleStatistic &statistic, Finding &finding) {
    if (static_cast<int>(std::min(a.size(), b.size())) < c.analysis.interval_runs) return;
    const Interval interval =
        bootstrap(a, b, statistic, {c.analysis.confidence, c.analysis.resamples, seed_of(c), 0});
    finding.low = interval.low, finding.high = interval.high;
}

/// Why nothing is concluded, if no p that so few runs can give would do.
void explain(const Case &c, double least, const std::string &of_what, Finding &finding) {
    if (finding.verdict != "inconclusive" || least < c.analysis.significance) return;
    const double rounded = std::round(least * 1000) / 1000;
    finding.note = "of so few runs p" + of_what + " is at least " + to_text(rounded);
}

// ---- Rank-sum tests ----

using Measure = std::function<Maybe(const RunHistory &history, int generations)>;

/// The values of a setting's runs; runs without one are reported in the note.
std::vector<double> measure_all(const Case &c, const SettingRuns &setting, const Measure &measure,
                                std::string &note) {
    std::vector<double> values;
    for (const RunHistory &history : setting.histories)
        if (const Maybe value = measure(history, c.generations)) values.push_back(*value);
    const int without = static_cast<int>(setting.histories.size() - values.size());
    if (without > 0)
        note += (note.empty() ? "" : "; ") + to_text(without) + " runs of " + setting.spec->name +
                " have no such value";
    return values;
}

Finding compare(const Case &c, const Measure &measure) {
    Finding finding{.effect_name = "A12", .verdict = "inconclusive"};
    std::string note;
    const std::vector<double> a = measure_all(c, *c.a, measure, note),
                              b = measure_all(c, *c.b, measure, note);
    if (!a.empty() && !b.empty()) {
        const RankSum test = rank_sum(a, b);
        finding.effect = a12(a, b), finding.p = test.p;
        finding.method = test.exact ? "exact" : "normal";
        add_interval(c, a, b, a12, finding);
        double least = test.least;
        if (c.claim.expect == "no_difference") {
            const Equivalence same = equivalence(a, b, c.claim.bound);
            finding.p_equivalence = same.p, least = same.least;
        }
        finding.verdict = rank_verdict(c.claim.expect, finding, c.analysis.significance);
        explain(c, least, finding.p_equivalence.has_value() ? " of equivalence" : "", finding);
    }
    if (!note.empty()) finding.note = note + (finding.note.empty() ? "" : "; ") + finding.note;
    return finding;
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

// ---- The permutation test ----

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

/// The mean of each run's curve over all generations.
std::vector<double> means_of_curves(const SettingRuns &setting, int generations) {
    std::vector<double> means;
    for (const RunHistory &history : setting.histories)
        means.push_back(mean(std::span(history.best).first(static_cast<std::size_t>(generations))));
    return means;
}

Finding mean_ahead(const Case &c) {
    // The bootstrap draws whole runs: its values are their places.
    std::vector<double> a(c.a->runs.size()), b(c.b->runs.size());
    std::iota(a.begin(), a.end(), 0.0);
    std::iota(b.begin(), b.end(), 0.0);
    Finding finding{.effect_name = "share of generations ahead", .effect = share_ahead(c, a, b)};
    add_interval(
        c, a, b, [&](std::span<const double> x, std::span<const double> y) { return share_ahead(c, x, y); },
        finding);

    const Permutation test =
        permutation_test(means_of_curves(*c.a, c.generations), means_of_curves(*c.b, c.generations),
                         {c.analysis.resamples, seed_of(c), 0});
    finding.p = test.p, finding.method = test.exact ? "exact" : "drawn";
    finding.verdict = "inconclusive";
    if (test.p < c.analysis.significance) {
        if (test.difference < 0) finding.verdict = "contradicted";
        if (test.difference > 0 && *finding.effect >= c.claim.level) finding.verdict = "reproduced";
    }
    explain(c, test.least, "", finding);
    return finding;
}

// ---- Counts ----

/// A run among those of both settings: its champion, and whether it is of the kind that a claim is about.
struct RankedRun {
    double fitness, elongation;
    bool of_a, counts;
};

std::vector<RankedRun> ranked_runs(const Case &c) {
    std::vector<RankedRun> all;
    for (const SettingRuns *setting : {c.a, c.b})
        for (const RunHistory &history : setting->histories) {
            const ChampionRow &champion = history.after.at(c.generations).champion;
            all.push_back({champion.fitness, champion.elongation, setting == c.a, setting == c.a});
        }
    return all;
}

/// How many of the best `count` are of the kind, if of equal fitness those that are not come first, or those that are.
int count_best(std::vector<RankedRun> all, int count, bool kind_first) {
    std::sort(all.begin(), all.end(), [&](const RankedRun &x, const RankedRun &y) {
        if (x.fitness != y.fitness) return x.fitness > y.fitness;
        return kind_first ? x.counts > y.counts : x.counts < y.counts;
    });
    return static_cast<int>(
        std::count_if(all.begin(), all.begin() + count, [](const RankedRun &x) { return x.counts; }));
}

/// Judges the best runs. Equal fitness counts against either verdict.
Finding judge_best(const Case &c, const std::vector<RankedRun> &all, const std::string &effect_name) {
    const int total = static_cast<int>(all.size()), count = std::min(c.claim.count, total);
    const int kind =
        static_cast<int>(std::count_if(all.begin(), all.end(), [](const RankedRun &x) { return x.counts; }));
    const int least = count_best(all, count, false), most = count_best(all, count, true);
    const auto so_many = [&](int found) { return hypergeometric_tail(found, total, kind, count); };
    const auto so_few = [&](int found) {
        return hypergeometric_tail(count - found, total, total - kind, count);
    };
    const auto two_sided = [](double one, double other) { return std::min(1.0, 2 * std::min(one, other)); };

    Finding finding{.effect_name = effect_name, .effect = least};
    finding.p = two_sided(so_many(least), so_few(most)), finding.method = "exact";
    finding.verdict = top_verdict(least, most, c.claim.count, *finding.p, c.analysis.significance);
    const int highest = std::min(count, kind), lowest = std::max(0, count + kind - total);
    explain(c, two_sided(so_many(highest), so_few(lowest)), "", finding);
    return finding;
}

Finding top_runs(const Case &c) {
    return judge_best(c, ranked_runs(c), "a's runs among the best " + to_text(c.claim.count));
}

Finding elongated(const Case &c) {
    std::vector<RankedRun> all = ranked_runs(c);
    std::vector<double> elongations;
    for (const RankedRun &contender : all) elongations.push_back(contender.elongation);
    const double usual = median(elongations);
    for (RankedRun &contender : all) contender.counts = contender.of_a && contender.elongation > usual;
    return judge_best(c, all, "a's and elongated among the best " + to_text(c.claim.count));
}

Finding cyclic(const Case &c) {
    // A body that falls over once makes no distance late; one that contracts once and glides has no late actuation.
    int found = 0;
    for (const RunHistory &history : c.a->histories) {
        const ChampionRow &champion = history.after.at(c.generations).champion;
        found += !is_cyclic(champion.late_share, champion.late_actuation, c.claim.level);
    }

    // The original's runs and ours together: how often would chance give ours this many?
    const int ours = static_cast<int>(c.a->runs.size()), original = c.analysis.design.design.seeds;
    const int stuck = found + std::min(c.claim.count, original);
    Finding finding{.effect_name = "runs without a lasting gait", .effect = found};
    finding.p = hypergeometric_tail(found, ours + original, stuck, ours), finding.method = "exact";
    finding.p_equivalence = binomial_lower_tail(found, ours, c.claim.bound);
    finding.verdict = "inconclusive";
    if (found > c.claim.count && *finding.p < c.analysis.significance) finding.verdict = "contradicted";
    if (found <= c.claim.count && *finding.p_equivalence < c.analysis.significance)
        finding.verdict = "reproduced";
    explain(c, binomial_lower_tail(0, ours, c.claim.bound), " of equivalence", finding);
    return finding;
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

std::string rank_verdict(std::string_view expect, const Finding &finding, double significance) {
    constexpr double even = 0.5;
    const bool differs = finding.p.value() < significance;
    if (expect == "no_difference") {
        if (finding.p_equivalence.value() < significance) return "reproduced";
        return differs ? "contradicted" : "inconclusive";
    }
    const double effect = finding.effect.value();
    if (!differs || effect == even) return "inconclusive";
    return (effect > even) == (expect == "greater") ? "reproduced" : "contradicted";
}

std::string top_verdict(int least, int most, int count, double p, double significance) {
    if (p >= significance) return "inconclusive";
    if (least == count) return "reproduced";
    return 2 * most < count ? "contradicted" : "inconclusive";
}

} // namespace planula
