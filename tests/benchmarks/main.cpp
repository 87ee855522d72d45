// SPDX-License-Identifier: MIT
// benchmarks FIRST LAST [ROW…]: the searches of core/evolution on the field's benchmarks, each row of the table
// with the seeds FIRST … LAST; the rows called TASK or TASK/SEARCH/SETTINGS, or all. Prints the table as CSV.
// benchmarks rows: prints the full name of every row.
#include "base/parallel.h"
#include "base/text.h"
#include "benchmarks/maze.h"
#include "benchmarks/poles.h"
#include "benchmarks/settings.h"
#include "benchmarks/solve.h"
#include "benchmarks/xor.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cstdio>
#include <string>

using namespace planula;
using namespace planula::benchmark;

namespace {

struct Published {
    std::string_view successes, evaluations, source; // evaluations: mean of the successes
};

struct Row {
    Task task;
    std::string_view search;
    Settings settings;
    int evaluations; // the budget of a run, rounded up to whole generations
    Published published;

    std::string name() const {
        return std::string(task.name) + '/' + std::string(search) + '/' + std::string(settings.name);
    }
    bool called(std::string_view word) const { return word == task.name || word == name(); }
};

/// Every benchmark, each with MultiNEAT's settings and with its own.
std::vector<Row> all_rows() {
    constexpr std::string_view stanley = "Stanley & Miikkulainen 2002", gomez = "Gomez et al. 2008",
                               lehman = "Lehman & Stanley 2011";
    std::vector<Row> rows;
    const auto add = [&](const Task &task, std::string_view search, int budget, const Settings &own,
                         const Published &published) {
        rows.push_back({task, search, multineat_settings(), budget, published});
        rows.push_back({task, search, own, budget, published});
    };
    const Settings small = stanley_settings(false), large = stanley_settings(true), mazes = lehman_settings();
    add(xor_task(), "neat", 60'000, small, {"100 of 100", "4755", stanley});
    add(pole_task(1, true), "neat", 30'000, small, {"all", "743", gomez});
    add(pole_task(1, false), "neat", 30'000, small, {"all", "1523", gomez});
    add(pole_task(2, true), "neat", 60'000, small, {"120 of 120", "3600", stanley});
    add(pole_task(2, false), "neat", 30'000, large, {"20 of 20", "33184", stanley});
    add(maze_task(medium_maze()), "neat", 30'000, mazes, {"", "56334", lehman});
    add(maze_task(medium_maze()), "novelty", 30'000, mazes, {"40 of 40", "18274", lehman});
    add(maze_task(hard_maze()), "neat", 30'000, mazes, {"3 of 40", "", lehman});
    add(maze_task(hard_maze()), "novelty", 30'000, mazes, {"39 of 40", "35109", lehman});
    return rows;
}

/// A statistic of the successes, "" without any.
std::string summary_of(const std::vector<double> &values, double (*statistic)(std::span<const double>)) {
    return values.empty() ? "" : to_fixed(statistic(values), 1);
}

void print(const Row &row, int first, int last) {
    const int population = row.settings.parameters.neat.population, seeds = last - first + 1;
    const int generations = (row.evaluations + population - 1) / population;
    std::vector<Solution> solutions(static_cast<std::size_t>(seeds));
    parallel_for(seeds, hardware_threads(), [&](int run) {
        solutions[run] = solve(row.task, row.search, row.settings.parameters,
                               static_cast<std::uint64_t>(first + run), generations);
    });

    std::vector<double> needed_generations, needed_evaluations;
    for (const Solution &solution : solutions)
        if (solution.solved) {
            needed_generations.push_back(solution.generations);
            needed_evaluations.push_back(static_cast<double>(solution.evaluations));
        }
    const std::string text =
        std::string(row.task.name) + ',' + std::string(row.search) + ',' + std::string(row.settings.name) +
        ',' + to_text(population) + ',' + to_text(generations * population) + ',' + to_text(seeds) + ',' +
        to_text(static_cast<int>(needed_evaluations.size())) + ',' + summary_of(needed_generations, median) +
        ',' + summary_of(needed_generations, mean) + ',' + summary_of(needed_evaluations, median) + ',' +
        summary_of(needed_evaluations, mean) + ',' + std::string(row.published.successes) + ',' +
        std::string(row.published.evaluations) + ',' + std::string(row.published.source);
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv) {
    const std::vector<Row> rows = all_rows();
    if (argc == 2 && argv[1] == std::string_view("rows")) {
        for (const Row &row : rows) std::puts(row.name().c_str());
        return 0;
    }
    const auto first = parse_int(argc > 1 ? argv[1] : ""), last = parse_int(argc > 2 ? argv[2] : "");
    if (!first || !last || *first < 1 || *last < *first || *last > 100'000) {
        std::fputs("usage: benchmarks FIRST LAST [ROW…], seeds from 1 to 100000 | benchmarks rows\n", stderr);
        return 2;
    }
    const std::vector<std::string_view> wanted(argv + 3, argv + argc);
    for (const std::string_view word : wanted)
        if (std::none_of(rows.begin(), rows.end(), [&](const Row &row) { return row.called(word); })) {
            std::fprintf(stderr, "benchmarks: no task and no row is called '%s'\n",
                         std::string(word).c_str());
            return 2;
        }

    std::puts("task,search,settings,population,budget,runs,successes,median_generations,mean_generations,"
              "median_evaluations,mean_evaluations,published_successes,published_mean_evaluations,source");
    for (const Row &row : rows)
        if (wanted.empty() || std::any_of(wanted.begin(), wanted.end(),
                                          [&](std::string_view word) { return row.called(word); }))
            print(row, static_cast<int>(*first), static_cast<int>(*last));
    return 0;
}
