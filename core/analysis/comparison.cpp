// SPDX-License-Identifier: MIT
#include "analysis/comparison.h"

#include "analysis/chance.h"
#include "analysis/survey.h"
#include "analysis/tables.h"
#include "base/check.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"
#include "statistics/bootstrap.h"
#include "statistics/effect_size.h"
#include "statistics/holm.h"
#include "statistics/rank_sum.h"
#include "statistics/shift.h"
#include "statistics/signed_rank.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace planula {

namespace {

using Values = std::map<std::int64_t, double>; // by seed

// ---- The runs ----

/// The runs of every contender; `specs` are theirs, with the generations that are asked for, and outlive the result.
std::vector<SettingRuns> find(std::span<const Contender> contenders, std::span<const Spec> specs) {
    std::vector<SettingRuns> all;
    std::string missing;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        all.push_back(runs_of_setting(specs[i], contenders[i].choice));
        if (!all.back().runs.empty()) continue;
        const int asked = specs[i].parameters.design.generations;
        missing += (missing.empty() ? "" : "\n") + std::string("there is no run of ") + contenders[i].name +
                   " below " + contenders[i].choice.folder.string() +
                   (asked > 1 ? " that has " + to_text(asked) + " generations" : "") +
                   "; planula run makes runs";
    }
    if (!missing.empty()) throw InputError(missing);
    return all;
}

/// As many generations as all runs have; which is the shortest is told if they differ.
int shared_generations(std::span<const Contender> contenders, std::span<const SettingRuns> settings) {
    const RecordedRun *shortest = nullptr, *longest = nullptr;
    for (const SettingRuns &setting : settings)
        for (const RecordedRun &run : setting.runs) {
            if (!shortest || run.generations < shortest->generations) shortest = &run;
            if (!longest || run.generations > longest->generations) longest = &run;
        }
    if (shortest->generations < longest->generations)
        contenders.front().choice.tell("compared after " + to_text(shortest->generations) +
                                       " generations, which all runs have; " + longest->folder.string() +
                                       " has " + to_text(longest->generations) + ", " +
                                       shortest->folder.string() + " no more than these");
    return shortest->generations;
}

/// Reads all runs up to these generations.
void read(std::vector<SettingRuns> &settings, int generations, const ComparisonPlan &plan) {
    struct Task {
        SettingRuns *setting;
        std::size_t run;
    };
    std::vector<Task> tasks;
    for (SettingRuns &setting : settings) {
        setting.generations = generations;
        setting.histories.resize(setting.runs.size());
        for (std::size_t run = 0; run < setting.runs.size(); ++run) tasks.push_back({&setting, run});
    }
    constexpr int most_threads = 8; // a run is read through a buffer of some 50 MB
    parallel_for(static_cast<int>(tasks.size()), std::min(hardware_threads(), most_threads), [&](int i) {
        const auto &[setting, run] = tasks[static_cast<std::size_t>(i)];
        check_files(setting->runs[run]);
        setting->histories[run] = read_history(setting->runs[run], generations, Analysis().fitness_classes,
                                               plan.direction_distance);
    });
}

/// Adds a row for each run of a setting; returns the values that there are.
Values add_runs(const SettingRuns &setting, const Contender &contender, const Measure &measure,
                Comparisons &result) {
    const std::vector<RunRow> rows = run_rows(setting);
    Values values;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Maybe value = measured(measure, rows[i], setting.histories[i].generations.back());
        result.runs.push_back({.measure = measure.name,
                               .unit = measure.unit,
                               .generations = setting.generations,
                               .setting = contender.name,
                               .seed = rows[i].seed,
                               .value = value});
        if (value) values[rows[i].seed] = *value;
    }
    return values;
}

// ---- One setting ----

std::vector<double> values_of(const Values &values) {
    std::vector<double> list;
    for (const auto &[seed, value] : values) list.push_back(value);
    return list;
}

Resampling resampling_of(const ComparisonPlan &plan, const std::string &what, IntervalKind kind) {
    return {plan.confidence, plan.resamples, bootstrap_seed("compare " + what), 0, kind};
}

void add_setting(const Values &values, const std::string &measure, const std::string &name,
                 const ComparisonPlan &plan, Comparisons &result) {
    ComparedSettingRow row{.measure = measure, .setting = name, .runs = static_cast<int>(values.size())};
    const std::vector<double> sample = values_of(values);
    if (!sample.empty()) row.median = median(sample);
    if (row.runs >= plan.interval_runs) {
        const Interval interval =
            bootstrap(sample, median, resampling_of(plan, measure + " " + name, IntervalKind::percentile));
        row.low = interval.low, row.high = interval.high;
    }
    result.settings.push_back(row);
}

// ---- Two settings ----

/// The values of both settings: pairs of the same seed, or all there are.
struct Matched {
    std::vector<double> a, b;
    int shared = 0; // seeds that both have
    bool pairs = false;
};

Matched match(const Values &a, const Values &b, bool by_seed) {
    Matched both;
    for (const auto &[seed, value] : a)
        if (const auto other = b.find(seed); other != b.end()) {
            both.a.push_back(value);
            both.b.push_back(other->second);
        }
    both.shared = static_cast<int>(both.a.size());
    both.pairs = by_seed && both.a.size() == std::min(a.size(), b.size());
    if (!both.pairs) both.a = values_of(a), both.b = values_of(b);
    return both;
}

/// What is left out, or why shared seeds make no pairs.
std::string note_of(const Matched &both, const Values &a, const Values &b, bool by_seed) {
    const int more = static_cast<int>(std::max(a.size(), b.size())) - both.shared;
    if (both.pairs && more > 0) return counted(more, "run") + " without a partner of the same seed left out";
    if (both.pairs || !by_seed || both.shared == 0) return "";
    return counted(both.shared, "pair") +
           " of the same seed among runs of other seeds: compared as independent "
           "samples; --seeds chooses those that are pairs";
}

/// The smallest p that m pairs, or m runs against n, can give.
double least_p(bool pairs, int m, int n) {
    double ways = 1; // to choose the signs, or m of all
    for (int i = 1; i <= m; ++i) ways *= pairs ? 2 : static_cast<double>(n + i) / i;
    return std::min(1.0, 2 / ways);
}

/// The fewest pairs, or runs of each setting, of which some p is below the significance.
int fewest(bool pairs, double significance) {
    int n = 1;
    while (least_p(pairs, n, n) >= significance) ++n;
    return n;
}

/// Why no p is below the significance, whatever the runs had reached; `least` is the smallest.
std::string why_too_few(const ComparisonRow &row, double least, double significance) {
    const bool pairs = row.pairs > 0;
    const int different = row.larger + row.smaller, enough = fewest(pairs, significance);
    const std::string never = to_fixed(least, least < 0.1 ? 3 : 2);
    if (pairs && different == 0) return "no pair differs, so that there is nothing to test";
    if (!pairs && std::min(row.runs_a, row.runs_b) >= enough)
        return "so many values are equal that p is never below " + never;
    std::string text =
        pairs ? counted(different, "pair") : counted(row.runs_a, "run") + " against " + to_text(row.runs_b);
    const bool is_one = pairs && different == 1;
    if (pairs && different < row.pairs) text += is_one ? " that differs" : " that differ";
    return text + (is_one ? " is" : " are") + " too few for a test, whose p is never below " + never +
           "; at least " + counted(enough, pairs ? "pair" : "run") + (pairs ? "" : " of each setting") +
           " are needed";
}

void add_note(const std::string &note, ComparisonRow &row) {
    row.note += (row.note.empty() ? "" : "; ") + note;
}

/// The test, and p if it could have been significant.
void add_test(std::span<const double> a, std::span<const double> b, double significance, ComparisonRow &row) {
    const auto add = [&](const char *name, const auto &test) {
        row.test = name;
        row.method = test.exact ? "exact" : "normal approximation";
        if (test.least < significance)
            row.p = test.p;
        else
            add_note(why_too_few(row, test.least, significance), row);
    };
    if (row.pairs > 0)
        add("signed-rank", signed_rank(a, b));
    else
        add("rank-sum", rank_sum(a, b));
}

void add_effect(std::span<const double> a, std::span<const double> b, const ComparisonPlan &plan,
                ComparisonRow &row) {
    const Shift by = row.pairs > 0 ? paired_shift(a, b, plan.confidence) : shift(a, b, plan.confidence);
    row.difference = by.estimate;
    if (by.interval) row.difference_low = by.interval->low, row.difference_high = by.interval->high;

    row.a12 = a12(a, b);
    const bool overlap = *row.a12 > 0 && *row.a12 < 1;
    if (std::min(row.runs_a, row.runs_b) < plan.interval_runs || !overlap) return;
    const Resampling resampling =
        resampling_of(plan, row.measure + " " + row.a + " against " + row.b, IntervalKind::bca);
    const Interval interval =
        row.pairs > 0 ? bootstrap_pairs(a, b, a12, resampling) : bootstrap(a, b, a12, resampling);
    row.a12_low = interval.low, row.a12_high = interval.high;
}

/// Adds p_holm, and a note where that could not be below the significance.
void correct(std::vector<ComparisonRow> &rows, double significance) {
    std::vector<double> p;
    for (const ComparisonRow &row : rows)
        if (row.p) p.push_back(*row.p);
    const std::vector<double> corrected = holm(p);
    std::size_t next = 0;
    for (ComparisonRow &row : rows) {
        if (!row.p) continue;
        row.p_holm = corrected[next++];
        const bool pairs = row.pairs > 0;
        const double least = least_p(pairs, pairs ? row.larger + row.smaller : row.runs_a, row.runs_b);
        if (least * static_cast<double>(p.size()) >= significance)
            add_note("of so few runs the smallest of " + to_text(static_cast<std::int64_t>(p.size())) +
                         " p is never significant when corrected",
                     row);
    }
}

ComparisonRow compare_two(const Values &a, const Values &b, ComparisonRow row, const ComparisonPlan &plan) {
    for (const auto &[values, name] : {std::pair{&a, &row.a}, {&b, &row.b}})
        if (values->empty()) {
            row.note = "no run of " + *name + " has a value";
            return row;
        }
    const Matched both = match(a, b, plan.by_seed);
    row.runs_a = static_cast<int>(both.a.size()), row.runs_b = static_cast<int>(both.b.size());
    row.pairs = both.pairs ? row.runs_a : 0;
    row.median_a = median(both.a), row.median_b = median(both.b);
    for (std::size_t i = 0; both.pairs && i < both.a.size(); ++i) {
        row.larger += both.a[i] > both.b[i];
        row.smaller += both.a[i] < both.b[i];
    }
    add_test(both.a, both.b, 1 - plan.confidence, row);
    add_effect(both.a, both.b, plan, row);
    if (const std::string note = note_of(both, a, b, plan.by_seed); !note.empty()) add_note(note, row);
    return row;
}

} // namespace

Comparisons compare(std::span<const Contender> contenders, const ComparisonPlan &plan) {
    CHECK(contenders.size() >= 2 && !plan.measures.empty());
    std::vector<Spec> specs;
    for (const Contender &contender : contenders) {
        specs.push_back(*contender.spec);
        specs.back().parameters.design.generations = std::max(plan.generations, 1);
    }
    std::vector<SettingRuns> settings = find(contenders, specs);
    Comparisons result{.confidence = plan.confidence};
    result.generations = plan.generations > 0 ? plan.generations : shared_generations(contenders, settings);
    read(settings, result.generations, plan);

    for (const Measure &measure : plan.measures) {
        std::vector<Values> values;
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            values.push_back(add_runs(settings[i], contenders[i], measure, result));
            add_setting(values.back(), measure.name, contenders[i].name, plan, result);
        }
        for (std::size_t i = 0; i < contenders.size(); ++i)
            for (std::size_t j = 0; j < contenders.size(); ++j) {
                const bool is_asked =
                    plan.against.empty() ? i < j : i != j && contenders[j].name == plan.against;
                if (is_asked)
                    result.rows.push_back(compare_two(
                        values[i], values[j],
                        {.measure = measure.name, .a = contenders[i].name, .b = contenders[j].name}, plan));
            }
    }
    correct(result.rows, 1 - plan.confidence);
    return result;
}

} // namespace planula
