// SPDX-License-Identifier: MIT
#include "analysis/comparison_text.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// Digits after the point so that a number shows at least so many significant ones.
int decimals_of(double value, int digits) {
    int decimals = 0;
    constexpr int most = 6;
    double size = std::abs(value), least = 1;
    for (int i = 1; i < digits; ++i) least *= 10;
    while (size > 0 && size < least && decimals < most) size *= 10, ++decimals;
    return decimals;
}

/// The numbers of a comparison, all with as many digits after the point: three significant ones of the larger median
/// and two of the difference, if that needs no more than one digit more; fewer if that shows every number whole.
class Numbers {
  public:
    explicit Numbers(const ComparisonRow &row)
        : decimals_(decimals_of(std::max(std::abs(*row.median_a), std::abs(*row.median_b)), 3)) {
        if (decimals_of(*row.difference, 2) > decimals_) ++decimals_;
        const Maybe shown[]{row.median_a, row.median_b, row.difference, row.difference_low,
                            row.difference_high};
        const auto is_whole = [&](const Maybe &value) {
            return !value || parse_double(to_fixed(*value, decimals_ - 1)) == *value;
        };
        while (decimals_ > 0 && std::all_of(std::begin(shown), std::end(shown), is_whole)) --decimals_;
    }
    std::string of(const Maybe &value) const {
        const std::string text = to_fixed(std::abs(*value), decimals_);
        const bool is_zero = text.find_first_not_of("0.") == text.npos;
        return (*value < 0 && !is_zero ? "−" : "") + text;
    }

  private:
    int decimals_;
};

/// The unit behind a number, unless the name of the measure says it.
std::string unit_of(const Measure &measure) {
    const std::string unit = measure.unit_words();
    return (" " + measure.words() + " ").find(unit + " ") == std::string::npos ? unit : "";
}

const Measure &measure_of(const ComparisonRow &row, const ComparisonPlan &plan) {
    return *std::find_if(plan.measures.begin(), plan.measures.end(),
                         [&](const Measure &measure) { return measure.name == row.measure; });
}

int tests_of(const Comparisons &comparisons) {
    return static_cast<int>(std::count_if(comparisons.rows.begin(), comparisons.rows.end(),
                                          [](const ComparisonRow &row) { return row.p.has_value(); }));
}

std::string p_line(const ComparisonRow &row, int tests) {
    const std::string by = "  Wilcoxon " + row.test + ", " + row.method;
    return p_text(*row.p) + by +
           (tests > 1 ? "; corrected over " + to_text(tests) + ": " + p_text(*row.p_holm) : "");
}

std::string test_words(const ComparisonRow &row, int tests) {
    std::string text = "Wilcoxon " + row.test + " test, ";
    text += row.method == "exact" ? "exact " : row.method + ", ";
    text += p_text(*row.p);
    if (tests > 1) text += ", Holm-corrected over " + to_text(tests) + " comparisons " + p_text(*row.p_holm);
    return text;
}

/// "Over 20 paired seeds", "In 20 runs against 18".
std::string runs_words(const ComparisonRow &row) {
    if (row.pairs > 0) return "Over " + counted(row.pairs, "paired seed");
    if (row.runs_a == row.runs_b) return "Over " + counted(row.runs_a, "independent run") + " of each";
    return "Over " + to_text(row.runs_a) + " against " + counted(row.runs_b, "independent run");
}

} // namespace

std::string percent_text(double share) { return to_text(std::round(1000 * share) / 10) + " %"; }

std::string p_text(double p) {
    constexpr double least = 0.0001;
    if (p < least) return "p < 0.0001";
    return "p = " + (p == 1 ? "1" : to_fixed(p, std::min(decimals_of(p, 2), 5)));
}

std::string lines_of(const ComparisonRow &row, const Comparisons &comparisons, const ComparisonPlan &plan) {
    const Measure &measure = measure_of(row, plan);
    std::string text = row.a + " against " + row.b + ": " + row.measure + " after " +
                       counted(comparisons.generations, "generation") + '\n';
    const auto line = [&](std::string name, const std::string &value) {
        constexpr std::size_t width = 12;
        name.resize(width, ' ');
        text += "  " + name + value + '\n';
    };
    const auto interval = [&](const Maybe &low, const Maybe &high, const auto &number) {
        if (!low) return std::string();
        return "  (" + percent_text(comparisons.confidence) + " interval " + number(low) + " to " +
               number(high) + ")";
    };
    line("runs", row.pairs > 0 ? counted(row.pairs, "pair") + " of the same seed"
                               : to_text(row.runs_a) + " against " + to_text(row.runs_b) + ", not paired");
    if (row.difference) {
        const Numbers numbers(row);
        const auto number = [&](const Maybe &value) { return numbers.of(value); };
        const auto share = [](const Maybe &value) { return to_fixed(*value, 2); };
        line("medians", numbers.of(row.median_a) + " and " + numbers.of(row.median_b) + unit_of(measure));
        line("difference", numbers.of(row.difference) + unit_of(measure) +
                               interval(row.difference_low, row.difference_high, number));
        if (row.pairs > 0)
            line("", "larger in " + to_text(row.larger) + " pairs, smaller in " + to_text(row.smaller));
        line("A12", share(row.a12) + interval(row.a12_low, row.a12_high, share));
    }
    if (row.p) line("test", p_line(row, tests_of(comparisons)));
    if (!row.note.empty()) line("note", row.note);
    return text;
}

std::string sentence_of(const ComparisonRow &row, const Comparisons &comparisons,
                        const ComparisonPlan &plan) {
    const Measure &measure = measure_of(row, plan);
    if (!row.difference)
        return row.a + " and " + row.b + " cannot be compared by " + measure.words() + ": " + row.note + ".";
    const Numbers numbers(row);
    if (row.pairs > 0 && row.larger + row.smaller == 0)
        return runs_words(row) + ", " + row.a + " and " + row.b + " had the same " + measure.words() +
               " in every pair after " + counted(comparisons.generations, "generation") + " (median " +
               numbers.of(row.median_a) + unit_of(measure) + ").";
    const bool is_reached = measure.name == "best_fitness" || measure.name == "best_displacement";
    std::string text =
        runs_words(row) + ", " + row.a + (is_reached ? " reached" : " had") + " a median " + measure.words() +
        " of " + numbers.of(row.median_a) + unit_of(measure) + " after " +
        counted(comparisons.generations, "generation") + ", against " + numbers.of(row.median_b) + " for " +
        row.b + " (" +
        (row.pairs > 0 ? "larger in " + to_text(row.larger) + " of " + counted(row.pairs, "pair") + ", "
                       : "") +
        "Hodges–Lehmann difference " + numbers.of(row.difference);
    if (row.difference_low)
        text += ", " + percent_text(comparisons.confidence) + " interval " + numbers.of(row.difference_low) +
                " to " + numbers.of(row.difference_high);
    text += "; " + (row.p ? test_words(row, tests_of(comparisons)) : row.note.substr(0, row.note.find(';')));
    text += "; A12 = " + to_fixed(*row.a12, 2);
    if (row.a12_low)
        text += ", " + percent_text(comparisons.confidence) + " interval " + to_fixed(*row.a12_low, 2) +
                " to " + to_fixed(*row.a12_high, 2);
    return text + ").";
}

} // namespace planula
