// SPDX-License-Identifier: MIT
#include "power/simulate.h"

#include "analysis/claims.h"
#include "base/math.h"
#include "base/parallel.h"
#include "base/random.h"
#include "core/analysis/fake_setting.h"
#include "statement/statistic_state.h"
#include "statistics/bootstrap.h"
#include "statistics/effect_size.h"
#include "statistics/summary.h"
#include "support/scripts.h"

#include <cmath>
#include <functional>

namespace planula::power {

namespace {

constexpr int runs_each = 20, draws = 1000;

double normal(Stream &stream) {
    const double radius = std::sqrt(-2 * math::log(1 - stream.uniform()));
    return radius * math::cos(2 * math::pi * stream.uniform());
}

std::vector<double> normals(Stream &stream, int count, double middle = 0, double spread = 1) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(middle + spread * normal(stream));
    return values;
}

/// By how many standard deviations two normal samples are apart for this A12: the square root of 2 times its quantile.
double shift_of(double effect) {
    double low = 0, high = 10;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (0.5 * math::erfc(-middle / 2) < effect ? low : high) = middle;
    }
    return low;
}

/// Two settings of twenty runs and one generation; b is drawn before a.
using Draw = std::function<void(Stream &, std::vector<SettingRuns> &)>;

struct Judged {
    std::string test, truth;
    std::string claim; // as a script states it, with the functions of experiments/paper/tests.lua
    Draw draw;
    int generations = 1;
};

/// A claim that is judged by a function of paper.tests with these options.
std::string claim_of(const std::string &test, const std::string &options) {
    const std::string settings = test == "cyclic" ? "a = 'ns'" : "a = 'ns', b = 'neat'";
    return "tests." + test + " { id = 'S', statement = 's', " + settings + ", " + options + " }";
}

/// The claims of all cases, in their order.
StatisticSource statistics_of(const std::vector<Judged> &all) {
    std::string text = "local tests = require 'paper.tests'\nreturn { statistics = { claims = {\n";
    for (const Judged &judged : all) text += judged.claim + ",\n";
    return {test::script(text + "} } }"), ""};
}

Analysis analysis_of(const Judged &judged) {
    Analysis analysis = fake_analysis();
    analysis.resamples = draws;
    analysis.interval_runs = runs_each + 1; // no verdict rests on an interval
    analysis.design.design.seeds = runs_each, analysis.design.neat.population = 1;
    analysis.design.design.generations = judged.generations;
    return analysis;
}

/// What one repetition gave, and whether the corrected p decides it as well.
struct Count {
    bool reproduced, contradicted, corrected;
};

Count judge(StatisticState &statistics, const Judged &judged, const Analysis &analysis, int number,
            int repetition) {
    const Spec ns = fake_spec("ns", judged.generations, 1), neat = fake_spec("neat", judged.generations, 1);
    const std::vector<double> zeros(runs_each);
    std::vector<SettingRuns> settings{fake_setting(ns, zeros), fake_setting(neat, zeros)};
    Stream stream(static_cast<std::uint64_t>(number), static_cast<std::uint32_t>(repetition), 0,
                  Purpose::sampling);
    judged.draw(stream, settings);
    Claim claim{.id = "S", .a = "ns", .b = judged.claim.starts_with("tests.cyclic") ? "" : "neat"};
    claim.judge = [&](const ClaimCase &of, Asked &asked) {
        return statistics.judge(static_cast<std::size_t>(number), of, asked);
    };
    const ClaimRow row = judge_claim(claim, recorded_data(analysis, settings));
    const bool reproduced = row.verdict == "reproduced", contradicted = row.verdict == "contradicted";
    const Maybe p = reproduced && row.p_equivalence.has_value() ? row.p_equivalence : row.p;
    return {reproduced, contradicted, family * *p < analysis.significance};
}

/// Each thread has the claims' functions in a Lua state of its own.
Outcome simulate(const StatisticSource &source, const Judged &judged, int number, int repetitions) {
    std::vector<Count> counts(static_cast<std::size_t>(repetitions));
    const Analysis analysis = analysis_of(judged);
    const int threads = hardware_threads();
    parallel_for(threads, threads, [&](int first) {
        StatisticState statistics(source, analysis, Allowance::reduce);
        for (int i = first; i < repetitions; i += threads)
            counts[i] = judge(statistics, judged, analysis, number, i);
    });
    Outcome outcome{
        .test = judged.test, .truth = judged.truth, .runs = runs_each, .repetitions = repetitions};
    const double one = 1.0 / repetitions;
    for (const Count &count : counts) {
        outcome.reproduced += one * count.reproduced, outcome.contradicted += one * count.contradicted;
        outcome.reproduced_corrected += one * (count.reproduced && count.corrected);
        outcome.contradicted_corrected += one * (count.contradicted && count.corrected);
    }
    return outcome;
}

// ---- Runs that are compared by one number ----

void set_values(SettingRuns &setting, const std::vector<double> &values) {
    for (std::size_t run = 0; run < values.size(); ++run) {
        for (GenerationRow &row : setting.histories[run].generations) row.best_fitness = values[run];
        for (auto &[after, facts] : setting.histories[run].after) facts.champion.fitness = values[run];
    }
}

/// Values of a and of b, made from a stream.
using Pair = std::function<std::pair<std::vector<double>, std::vector<double>>(Stream &)>;

Draw draw_values(const Pair &pair) {
    return [pair](Stream &stream, std::vector<SettingRuns> &settings) {
        const auto [a, b] = pair(stream);
        set_values(settings[0], a), set_values(settings[1], b);
    };
}

Pair shifted(double effect) {
    return [shift = shift_of(effect)](Stream &stream) {
        auto b = normals(stream, runs_each), a = normals(stream, runs_each, shift);
        return std::pair{a, b};
    };
}

/// Every value changed by a function that never falls.
Pair changed(const Pair &pair, double (*change)(double)) {
    return [=](Stream &stream) {
        auto [a, b] = pair(stream);
        for (auto *values : {&a, &b})
            for (double &value : *values) value = change(value);
        return std::pair{a, b};
    };
}

/// b varies five times as much as a.
Pair unequal(double effect) {
    constexpr double factor = 5;
    return [shift = shift_of(effect) * std::sqrt((1 + factor * factor) / 2)](Stream &stream) {
        auto b = normals(stream, runs_each, 0, factor), a = normals(stream, runs_each, shift);
        return std::pair{a, b};
    };
}

/// Runs of one seed have the same generation 0: their values correlate.
Pair correlated(double effect, double correlation) {
    return [shift = shift_of(effect), correlation](Stream &stream) {
        const auto common = normals(stream, runs_each, 0, std::sqrt(correlation));
        auto b = normals(stream, runs_each, 0, std::sqrt(1 - correlation)),
             a = normals(stream, runs_each, shift, std::sqrt(1 - correlation));
        for (int i = 0; i < runs_each; ++i) a[i] += common[i], b[i] += common[i];
        return std::pair{a, b};
    };
}

std::string truth_of(double effect, const std::string &more = "") {
    return "A12 = " + to_text(effect) + more;
}

void add_rank_tests(std::vector<Judged> &all) {
    const std::string difference = "rank-sum: a difference", none = "equivalence: no difference";
    const std::string greater = claim_of("best_at_generation", "expect = 'greater'");
    const std::string same = claim_of("best_at_generation", "expect = 'no_difference', bound = 0.21");
    const auto whole = [](double value) { return std::floor(value); };
    for (const double effect : {0.5, 0.64, 0.71, 0.8})
        all.push_back({difference, truth_of(effect), greater, draw_values(shifted(effect))});
    all.push_back(
        {difference, truth_of(0.5, " and skewed"), greater, draw_values(changed(shifted(0.5), math::exp))});
    all.push_back(
        {difference, truth_of(0.5, " in whole numbers"), greater, draw_values(changed(shifted(0.5), whole))});
    all.push_back({difference, truth_of(0.5, " and 5 times the spread"), greater, draw_values(unequal(0.5))});
    for (const double correlation : {0.25, 0.5})
        for (const double effect : {0.5, 0.71})
            all.push_back({difference,
                           truth_of(effect, " and runs of a seed correlate by " + to_text(correlation)),
                           greater, draw_values(correlated(effect, correlation))});
    for (const double effect : {0.5, 0.56, 0.64, 0.71, 0.8, 0.9})
        all.push_back({none, truth_of(effect), same, draw_values(shifted(effect))});
    all.push_back({none, truth_of(0.71, " and 5 times the spread"), same, draw_values(unequal(0.71))});
    all.push_back(
        {none, truth_of(0.5, " in whole numbers"), same, draw_values(changed(shifted(0.5), whole))});
    all.push_back({none, truth_of(0.71, " and runs of a seed correlate by 0.5"), same,
                   draw_values(correlated(0.71, 0.5))});
}

// ---- Curves ----

constexpr int curve_generations = 100;

/// The best of each generation: what the run is worth, approached by and by, and fluctuations that last some ten
/// generations. A run's mean over the generations then differs between searches by about this A12.
Draw draw_curves(double effect) {
    return [shift = shift_of(effect)](Stream &stream, std::vector<SettingRuns> &settings) {
        for (SettingRuns *setting : {&settings[1], &settings[0]})
            for (RunHistory &history : setting->histories) {
                const double worth = 10 + normal(stream) + (setting == &settings[0] ? shift : 0);
                double lasting = 0;
                for (GenerationRow &row : history.generations) {
                    lasting = 0.9 * lasting + 0.3 * normal(stream);
                    const double time = row.generation + 1.0;
                    row.best_fitness = worth * time / (time + 10) + lasting;
                }
            }
    };
}

void add_curve_tests(std::vector<Judged> &all) {
    for (const double level : {1.0, 0.5})
        for (const double effect : {0.5, 0.64, 0.71, 0.8})
            all.push_back({level == 1 ? "mean ahead in every generation" : "mean ahead in most generations",
                           truth_of(effect), claim_of("mean_ahead", "level = " + to_text(level)),
                           draw_curves(effect), curve_generations});
}

// ---- Counts ----

void add_count_tests(std::vector<Judged> &all) {
    for (const int count : {5, 3})
        for (const double effect : {0.5, 0.71, 0.8, 0.9})
            all.push_back({"the best " + to_text(count) + " runs", truth_of(effect),
                           claim_of("top_runs", "count = " + to_text(count)), draw_values(shifted(effect))});
    for (const double effect : {0.5, 0.8}) {
        const auto lengthen = [draw = draw_values(shifted(effect))](Stream &stream,
                                                                    std::vector<SettingRuns> &settings) {
            draw(stream, settings);
            for (SettingRuns &setting : settings)
                for (RunHistory &history : setting.histories)
                    history.after.at(1).champion.elongation = 3 + normal(stream);
        };
        all.push_back({"the best 2 runs and elongated", truth_of(effect), claim_of("elongated", "count = 2"),
                       lengthen});
    }
    for (const int count : {0, 1})
        for (const double share : {0.01, 0.05, 0.25, 0.5}) {
            const auto stop = [share](Stream &stream, std::vector<SettingRuns> &settings) {
                for (RunHistory &history : settings[0].histories)
                    if (stream.chance(share)) history.after.at(1).champion.late_share = 0;
            };
            all.push_back({"cyclic gaits but " + to_text(count), "share without " + to_text(share),
                           claim_of("cyclic", "level = 0.1, bound = 0.25, count = " + to_text(count)), stop});
        }
}

// ---- Intervals ----

Coverage cover(const std::string &interval, const std::string &values, int runs, int repetitions,
               const std::function<bool(Stream &, const Resampling &)> &holds) {
    std::vector<char> held(static_cast<std::size_t>(repetitions));
    parallel_for(repetitions, hardware_threads(), [&](int i) {
        Stream stream(static_cast<std::uint64_t>(runs), static_cast<std::uint32_t>(i), 0, Purpose::sampling);
        held[i] = holds(stream, {0.95, draws, static_cast<std::uint64_t>(i), 0});
    });
    double covered = 0;
    for (const char hit : held) covered += static_cast<double>(hit) / repetitions;
    return {interval, values, runs, repetitions, covered};
}

} // namespace

std::vector<Outcome> outcomes(int repetitions) {
    std::vector<Judged> all;
    add_rank_tests(all), add_curve_tests(all), add_count_tests(all);
    std::vector<Outcome> result;
    const StatisticSource source = statistics_of(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        result.push_back(simulate(source, all[i], static_cast<int>(i), repetitions));
    return result;
}

std::vector<Coverage> coverages(int repetitions) {
    std::vector<Coverage> result;
    for (const int runs : {3, 5, 10, 20, 50}) {
        result.push_back(
            cover("mean", "normal", runs, repetitions, [=](Stream &stream, const Resampling &resampling) {
                const Interval found = bootstrap_mean(normals(stream, runs), resampling);
                return found.low <= 0 && 0 <= found.high;
            }));
        result.push_back(
            cover("mean", "lognormal", runs, repetitions, [=](Stream &stream, const Resampling &resampling) {
                std::vector<double> values = normals(stream, runs);
                for (double &value : values) value = math::exp(value);
                const Interval found = bootstrap_mean(values, resampling);
                const double truth = math::exp(0.5);
                return found.low <= truth && truth <= found.high;
            }));
        for (const double effect : {0.5, 0.8})
            result.push_back(
                cover("A12", truth_of(effect), runs, repetitions,
                      [=, shift = shift_of(effect)](Stream &stream, const Resampling &resampling) {
                          const auto b = normals(stream, runs), a = normals(stream, runs, shift);
                          const Interval found = bootstrap(a, b, a12, resampling);
                          return found.low <= effect && effect <= found.high;
                      }));
    }
    return result;
}

} // namespace planula::power
