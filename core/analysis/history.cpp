// SPDX-License-Identifier: MIT
#include "analysis/history.h"

#include "base/check.h"
#include "statistics/entropy.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// What accumulates over the individuals of a run.
class Tally {
  public:
    explicit Tally(int population) : population_(population) {}

    void add(const IndividualRow &row) {
        if (row.slot == 0) fitness_.clear(), valid_.clear();
        fitness_.push_back(row.fitness);
        if (row.penalty > 0) valid_.push_back(row.fitness);
        if (row.fitness > 0) ++sizes_[row.cells], ++viable_;
        head(Vec2d{row.end_x, row.end_y} - Vec2d{row.rest_x, row.rest_y});
    }

    /// After a generation: on which side its best ended; the middle counts for neither.
    void lead(double x) {
        const int side = (x > 0) - (x < 0);
        if (side == 0) return;
        switches_ += side_ != 0 && side != side_;
        side_ = side;
    }

    RunFacts facts(const ChampionRow &champion) const {
        RunFacts facts;
        facts.champion = champion;
        std::vector<std::int64_t> counts;
        for (const auto &[size, count] : sizes_) counts.push_back(count);
        facts.size_entropy = entropy_of_counts(counts);
        facts.viable = viable_;
        facts.valid_share = static_cast<double>(valid_.size()) / population_;
        if (!valid_.empty() && champion.fitness > 0)
            facts.fitness_spread = (quantile(valid_, 0.75) - quantile(valid_, 0.25)) / champion.fitness;
        if (moved_ > 0) facts.direction_resultant = length(heading_) / static_cast<double>(moved_);
        facts.side_switches = switches_;
        return facts;
    }

    /// How the last generation's fitness spreads over equal classes from 0 to the champion's.
    std::vector<double> shares(double best, int classes) const {
        std::vector<double> shares(static_cast<std::size_t>(classes));
        for (const double fitness : fitness_) {
            const double place = best > 0 ? std::floor(fitness / best * classes) : 0;
            shares[static_cast<std::size_t>(std::clamp(place, 0.0, classes - 1.0))] += 1.0 / population_;
        }
        return shares;
    }

  private:
    void head(Vec2d moved) {
        const double distance = length(moved);
        if (distance == 0) return;
        heading_ += moved / distance;
        ++moved_;
    }

    int population_;
    std::vector<double> fitness_, valid_; // of the present generation
    std::map<int, std::int64_t> sizes_;   // individuals by cell count
    std::int64_t viable_ = 0, moved_ = 0;
    Vec2d heading_; // sum of unit vectors
    int side_ = 0, switches_ = 0;
};

/// Reads generations.csv up to `generations` rows into the history.
void read_generations(const RecordedRun &run, int generations, std::vector<int> &best_slots,
                      RunHistory &history) {
    TableReader<GenerationRow> reader(run.folder);
    for (int number = 0; number < generations; ++number) {
        GenerationRow row;
        if (!reader.next(row)) reader.refuse("generations are missing at the end");
        if (row.generation != number)
            reader.refuse("generation " + to_text(row.generation) + " where " + to_text(number) +
                          " must follow");
        if (row.best_slot < 0 || row.best_slot >= run.population)
            reader.refuse("best_slot = " + to_text(row.best_slot) + " in a population of " +
                          to_text(run.population));
        history.best.push_back(row.best_fitness);
        history.shape_diversity.push_back(row.shape_diversity);
        best_slots.push_back(row.best_slot);
        if (number == 0) history.first = row;
        history.last = row;
    }
}

const ChampionRow &champion_after(const std::vector<ChampionRow> &champions, int generations) {
    const auto later = std::find_if(champions.begin(), champions.end(),
                                    [&](const ChampionRow &row) { return row.generation >= generations; });
    return *(later - 1);
}

} // namespace

std::vector<ChampionRow> read_champions(const RecordedRun &run) {
    TableReader<ChampionRow> reader(run.folder);
    std::vector<ChampionRow> champions;
    for (ChampionRow row; reader.next(row);) {
        const bool follows = champions.empty() ? row.generation == 0
                                               : row.generation > champions.back().generation &&
                                                     row.fitness > champions.back().fitness;
        if (!follows) reader.refuse("this is not the next champion");
        champions.push_back(row);
    }
    if (champions.empty()) reader.refuse("there is no champion");
    return champions;
}

RunHistory read_history(const RecordedRun &run, std::span<const int> marks, int fitness_classes) {
    CHECK(!marks.empty() && marks.front() >= 1 && marks.back() <= run.generations, run.seed);
    const int generations = marks.back();
    RunHistory history;
    history.seed = run.seed;
    std::vector<int> best_slots;
    read_generations(run, generations, best_slots, history);
    const std::vector<ChampionRow> champions = read_champions(run);
    history.crowned = champions.back();

    Tally tally(run.population);
    each_individual(run, generations, [&](const IndividualRow &row) {
        tally.add(row);
        if (row.slot == best_slots[row.generation])
            history.best_moved.push_back(Vec2d{row.end_x, row.end_y} - Vec2d{row.rest_x, row.rest_y});

        // The generation is complete with its last slot.
        if (row.slot + 1 < run.population) return;
        tally.lead(history.best_moved.back().x);
        const int done = row.generation + 1;
        if (std::binary_search(marks.begin(), marks.end(), done))
            history.after[done] = tally.facts(champion_after(champions, done));
    });
    history.fitness_shares = tally.shares(history.after.at(generations).champion.fitness, fitness_classes);
    return history;
}

} // namespace planula
