// SPDX-License-Identifier: MIT
#include "analysis/density.h"

#include "experiment/sample.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace planula {

namespace {

constexpr int most_generation_bins = 60, most_place_bins = 80;
constexpr double narrowest_bin = 0.125;

/// Generations in a bin.
int bin_length(int generations) { return (generations + most_generation_bins - 1) / most_generation_bins; }

/// A sampled individual, and how many of its generation it stands for.
struct Ended {
    int generation;
    double x, individuals;
};

/// The viable individuals of the sample that a run of every length records.
std::vector<Ended> sampled_ends(const RecordedRun &run, int generations) {
    std::vector<Ended> sample;
    each_individual(run, generations, [&](const IndividualRow &row) {
        const bool is_in = is_in_sample(run.record, static_cast<std::uint64_t>(run.seed), run.population,
                                        row.generation, row.slot);
        if (!is_in || row.outcome != name_of(Outcome::viable)) return;
        const double share = run.record.share(run.population, row.generation + 1);
        sample.push_back({row.generation, row.finish_x - row.rest_x, 1 / share});
    });
    return sample;
}

double bin_width(std::span<const Ended> sample) {
    double reach = 0, width = narrowest_bin;
    for (const Ended &one : sample) reach = std::max(reach, std::abs(one.x));
    while (2 * reach > most_place_bins * width) width *= 2;
    return width;
}

} // namespace

std::vector<EndpointDensityRow> endpoint_density_rows(const SettingRuns &setting,
                                                      const Representative &chosen) {
    struct Bin {
        int recorded = 0;
        double individuals = 0;
    };
    const RecordedRun &run = setting.runs[chosen.run];
    const std::vector<Ended> sample = sampled_ends(run, setting.generations);
    const int length = bin_length(setting.generations);
    const double width = bin_width(sample);
    std::map<std::pair<int, int>, Bin> bins; // by their numbers along generations and places
    for (const Ended &one : sample) {
        Bin &bin = bins[{one.generation / length, static_cast<int>(std::floor(one.x / width))}];
        ++bin.recorded;
        bin.individuals += one.individuals;
    }
    std::vector<EndpointDensityRow> rows;
    for (const auto &[numbers, bin] : bins) {
        const auto [when, where] = numbers;
        rows.push_back({setting.spec->name, run.seed, chosen.role, when * length,
                        std::min((when + 1) * length, setting.generations) - 1, where * width,
                        (where + 1) * width, bin.recorded, bin.individuals});
    }
    return rows;
}

std::vector<FitnessHistoryRow> fitness_history_rows(const SettingRuns &setting) {
    const int length = bin_length(setting.generations), runs = static_cast<int>(setting.histories.size());
    const std::size_t classes = setting.histories.front().fitness_shares.front().size();
    std::vector<FitnessHistoryRow> rows;
    for (int first = 0; first < setting.generations; first += length) {
        const int end = std::min(first + length, setting.generations);
        for (std::size_t i = 0; i < classes; ++i) {
            double sum = 0;
            for (const RunHistory &history : setting.histories)
                for (int generation = first; generation < end; ++generation)
                    sum += history.fitness_shares[static_cast<std::size_t>(generation)][i];
            const double count = static_cast<double>(classes);
            rows.push_back({setting.spec->name, runs, first, end - 1, static_cast<double>(i) / count,
                            static_cast<double>(i + 1) / count, sum / (runs * (end - first))});
        }
    }
    return rows;
}

} // namespace planula
