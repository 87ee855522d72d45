// SPDX-License-Identifier: MIT
// multineat FIRST LAST: the regression task of tests/core/evolution/regression_task.h with the seeds FIRST … LAST,
// beside what MultiNEAT shows over 50 runs of it. Prints both medians and quartiles as CSV, and how surely the
// medians differ.
//
// Only medians and quartiles of the library are known. So z counts how many of our runs lie above its median
// (Mathisen's test, 1943): of runs of one distribution it is half of them, give or take ½ √(1/ours + 1/theirs),
// since their median is a sample's, too. Runs that round to the printed median count half.
#include "base/parallel.h"
#include "base/text.h"
#include "core/evolution/multineat_reference.h"
#include "statistics/summary.h"

#include <cstdio>
#include <string>

using namespace planula;
using namespace planula::regression;

namespace {

double z_of(const Reference &reference, const std::vector<double> &values) {
    const double median = number(reference.median), tie = rounding(reference.median) * (1 + 1e-9);
    double above = 0;
    for (const double value : values) above += std::abs(value - median) <= tie ? 0.5 : value > median ? 1 : 0;
    const double ours = static_cast<double>(values.size());
    return (above / ours - 0.5) / (0.5 * std::sqrt(1 / ours + 1.0 / reference_runs));
}

/// To three digits that count.
std::string rounded(double value) {
    int decimals = 2;
    for (double size = std::abs(value); size > 0 && size < 1 && decimals < 12; size *= 10) ++decimals;
    return to_text(*parse_double(to_fixed(value, decimals)));
}

} // namespace

int main(int argc, char **argv) {
    const auto first = parse_int(argc == 3 ? argv[1] : ""), last = parse_int(argc == 3 ? argv[2] : "");
    if (!first || !last || *first < 1 || *last < *first || *last > 100'000) {
        std::fputs("usage: multineat FIRST LAST, seeds from 1 to 100000\n", stderr);
        return 2;
    }

    std::puts(
        "network,quantity,generation,library_low,library_median,library_high,planula_low,planula_median,"
        "planula_high,z");
    const int runs = static_cast<int>(*last - *first) + 1;
    for (const bool recurrent : {false, true}) {
        std::vector<std::vector<Row>> rows(static_cast<std::size_t>(runs));
        parallel_for(runs, hardware_threads(), [&](int run) {
            rows[run] = evolve(recurrent, 100, static_cast<std::uint64_t>(*first + run));
        });
        for (const Reference &reference : references) {
            if (reference.recurrent != recurrent) continue;
            std::vector<double> values;
            for (const auto &run : rows) values.push_back(run[reference.generation].*reference.value);
            std::string line = std::string(recurrent ? "recurrent," : "feed-forward,") +
                               std::string(reference.quantity) + ',' + to_text(reference.generation);
            for (const std::string_view text : {reference.low, reference.median, reference.high})
                line += ',' + std::string(text);
            for (const double probability : {0.25, 0.5, 0.75})
                line += ',' + rounded(quantile(values, probability));
            std::printf("%s,%s\n", line.c_str(), to_fixed(z_of(reference, values), 1).c_str());
        }
    }
    return 0;
}
