// SPDX-License-Identifier: MIT
#include "analysis/history.h"

#include "base/check.h"
#include "base/vec2.h"
#include "experiment/sample.h"
#include "statistics/entropy.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// What accumulates over the generations of a run.
class Tally {
  public:
    explicit Tally(int population) : population_(population) {}

    void add(const GenerationRow &row) { last_ = row; }
    void add(const SizeRow &row) { sizes_[row.cells] += row.individuals; }

    RunFacts facts(const ChampionRow &champion) const {
        RunFacts facts;
        facts.champion = champion;
        std::vector<std::int64_t> counts;
        for (const auto &[size, count] : sizes_) {
            counts.push_back(count);
            facts.with_fitness += count;
        }
        facts.size_entropy = entropy_of_counts(counts);
        facts.valid_share = static_cast<double>(last_.valid) / population_;
        if (last_.best_fitness > 0)
            facts.fitness_spread = (last_.fitness_high - last_.fitness_low) / last_.best_fitness;
        return facts;
    }

  private:
    int population_;
    GenerationRow last_;
    std::map<int, std::int64_t> sizes_; // individuals by cell count
};

/// How often the best so far ended on another side, before a generation; nearer than the distance counts for neither.
int side_switches(const std::vector<ChampionRow> &champions, int generations, double direction_distance) {
    int switches = 0, before = 0;
    for (const ChampionRow &champion : champions) {
        if (champion.generation >= generations) break;
        if (champion.x == 0 || std::abs(champion.x) < direction_distance) continue;
        const int side = champion.x > 0 ? 1 : -1;
        switches += before != 0 && side != before;
        before = side;
    }
    return switches;
}

/// Where the sampled individuals of a run went that moved.
class Headings {
  public:
    Headings(const RecordedRun &run, int generations, double direction_distance)
        : record_(run.record), population_(run.population) {
        each_individual(run, generations, [&](const IndividualRow &row) {
            const Vec2d moved{row.finish_x - row.rest_x, row.finish_y - row.rest_y};
            const double distance = length(moved),
                         lot_ = lot(static_cast<std::uint64_t>(run.seed), row.generation, row.slot);
            if (distance == 0 || distance < direction_distance || lot_ >= share_after(row.generation + 1))
                return;
            headings_.push_back({row.generation, lot_, moved / distance});
        });
    }

    /// The length of their mean over those in the sample of a run of that length.
    Maybe resultant(int generations) const {
        Vec2d sum;
        double count = 0;
        for (const Heading &heading : headings_) {
            if (heading.generation >= generations || heading.lot >= share_after(generations)) continue;
            sum += heading.unit;
            ++count;
        }
        return count > 0 ? Maybe(length(sum) / count) : std::nullopt;
    }

  private:
    struct Heading {
        int generation;
        double lot;
        Vec2d unit;
    };

    double share_after(int generations) const { return record_.share(population_, generations); }

    Recording record_;
    int population_;
    std::vector<Heading> headings_;
};

/// The rows of a table whose generations ascend, a generation at a time.
template <class Row> class ByGeneration {
  public:
    explicit ByGeneration(const RecordedRun &run) : reader_(run.folder) { more_ = reader_.next(row_); }

    /// Calls visit(row) for each row of this generation, which follows the one before.
    template <class Visit> void each(int generation, Visit &&visit) {
        for (; more_ && row_.generation == generation; more_ = reader_.next(row_)) visit(row_);
        if (more_ && row_.generation < generation)
            reader_.refuse("generation " + to_text(row_.generation) + " after " + to_text(generation));
    }

  private:
    TableReader<Row> reader_;
    Row row_;
    bool more_ = false;
};

/// The next row of generations.csv.
GenerationRow next_generation(TableReader<GenerationRow> &reader, int number, int population) {
    GenerationRow row;
    if (!reader.next(row)) reader.refuse("generations are missing at the end");
    if (row.generation != number)
        reader.refuse("generation " + to_text(row.generation) + " where " + to_text(number) + " must follow");
    if (row.best_slot < 0 || row.best_slot >= population)
        reader.refuse("best_slot = " + to_text(row.best_slot) + " in a population of " + to_text(population));
    return row;
}

/// How the fitness of each of the first generations spreads over equal classes from 0 to its highest.
std::vector<std::vector<double>> read_fitness_shares(const RecordedRun &run, int generations, int classes) {
    std::vector<std::vector<double>> shares(static_cast<std::size_t>(generations),
                                            std::vector<double>(static_cast<std::size_t>(classes)));
    TableReader<FitnessClassRow> reader(run.folder);
    for (FitnessClassRow row; reader.next(row) && row.generation < generations;) {
        if (row.generation < 0) reader.refuse("generation = " + to_text(row.generation));
        if (row.percent < 0 || row.percent > 99) reader.refuse("percent = " + to_text(row.percent));
        shares[static_cast<std::size_t>(row.generation)]
              [static_cast<std::size_t>(row.percent * classes / 100)] +=
            static_cast<double>(row.individuals) / run.population;
    }
    return shares;
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

const ChampionRow &champion_after(const std::vector<ChampionRow> &champions, int generations) {
    const auto later = std::find_if(champions.begin(), champions.end(),
                                    [&](const ChampionRow &row) { return row.generation >= generations; });
    CHECK(later != champions.begin(), generations);
    return *(later - 1);
}

RunHistory read_history(const RecordedRun &run, int generations, int fitness_classes,
                        double direction_distance) {
    CHECK(generations >= 1 && generations <= run.generations, generations, run.seed);
    CHECK(fitness_classes >= 1 && 100 % fitness_classes == 0, fitness_classes);
    const std::vector<ChampionRow> champions = read_champions(run);
    RunHistory history;
    history.seed = run.seed;
    Tally tally(run.population);
    TableReader<GenerationRow> rows(run.folder);
    ByGeneration<SizeRow> sizes(run);
    for (int number = 0; number < generations; ++number) {
        history.generations.push_back(next_generation(rows, number, run.population));
        tally.add(history.generations.back());
        sizes.each(number, [&](const SizeRow &size) { tally.add(size); });
        history.after[number + 1] = tally.facts(champion_after(champions, number + 1));
    }
    const Headings headings(run, generations, direction_distance);
    for (auto &[generation, facts] : history.after) {
        facts.direction_resultant = headings.resultant(generation);
        facts.side_switches = side_switches(champions, generation, direction_distance);
    }
    history.fitness_shares = read_fitness_shares(run, generations, fitness_classes);
    return history;
}

} // namespace planula
