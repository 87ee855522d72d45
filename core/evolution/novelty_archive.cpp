// SPDX-License-Identifier: MIT
#include "evolution/novelty_archive.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace planula {

void save(const ArchiveEntry &entry, StateWriter &writer) {
    writer.integer(entry.generation).integer(entry.genome).real(entry.novelty);
    for (const double value : entry.behaviour) writer.real(value);
}

ArchiveEntry load_archive_entry(StateReader &reader, std::size_t length) {
    ArchiveEntry entry;
    entry.generation = static_cast<int>(reader.integer(0, std::numeric_limits<int>::max()));
    entry.genome = reader.integer(0, std::numeric_limits<std::int64_t>::max());
    entry.novelty = reader.finite();
    entry.behaviour.resize(length);
    for (double &value : entry.behaviour) value = reader.finite();
    return entry;
}

double novelty(std::span<const Neighbour> neighbours) {
    if (neighbours.empty()) return 0;
    double sum = 0;
    for (const Neighbour &neighbour : neighbours) sum += std::sqrt(neighbour.squared);
    return sum / static_cast<double>(neighbours.size());
}

std::vector<std::vector<Neighbour>> NoveltyArchive::neighbours(std::span<const Evaluation> evaluations) {
    check_behaviours(evaluations, length_);
    std::vector<std::vector<Neighbour>> result(evaluations.size());
    for (std::size_t self = 0; self < evaluations.size(); ++self) {
        if (!evaluations[self].valid()) continue;
        const auto &place = evaluations[self].behaviour;
        // The archive first: after it few of the others are near enough to be sorted in.
        Nearest nearest(parameters_.novelty_neighbours);
        index_.offer(place, evaluations.size(), nearest);
        for (std::size_t other = 0; other < evaluations.size(); ++other)
            if (other != self && evaluations[other].valid())
                nearest.offer({squared_distance(place, evaluations[other].behaviour), other});
        result[self] = nearest.list();
    }
    return result;
}

void NoveltyArchive::extend(const Population &population, std::span<const Evaluation> evaluations,
                            std::span<const double> novelty) {
    CHECK(evaluations.size() == population.genomes.size() && novelty.size() == evaluations.size());
    // A walk in slot order; the threshold moves on the way.
    bool added_any = false;
    for (std::size_t slot = 0; slot < evaluations.size(); ++slot) {
        if (!evaluations[slot].valid()) continue;
        const bool added = novelty[slot] > threshold_;
        run_ = added ? run_ + 1 : 0;
        if (!added) continue;
        added_any = true;
        add({population.generation, population.genomes[slot].id, evaluations[slot].behaviour, novelty[slot]},
            evaluations[slot].fitness);
        if (run_ > parameters_.archive_run) threshold_ *= parameters_.archive_raise;
    }

    // After a long time without additions the threshold falls, and the count starts again.
    quiet_ = added_any ? 0 : quiet_ + 1;
    if (quiet_ < parameters_.archive_patience) return;
    threshold_ = std::max(parameters_.archive_floor, threshold_ * parameters_.archive_lower);
    quiet_ = 0;
}

void NoveltyArchive::add(ArchiveEntry entry, double fitness) {
    index_.add(entry.behaviour);
    entries_.push_back(std::move(entry));
    fitness_.push_back(fitness);
}

void NoveltyArchive::save(StateWriter &writer) const {
    writer.group("archive").real(threshold_).integer(run_).integer(quiet_);
    writer.integer(static_cast<std::int64_t>(length_)).integer(static_cast<std::int64_t>(entries_.size()));
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        planula::save(entries_[i], writer);
        writer.real(fitness_[i]);
    }
}

void NoveltyArchive::load(StateReader &reader) {
    constexpr int largest = std::numeric_limits<int>::max();
    *this = NoveltyArchive(parameters_);
    reader.group("archive");
    threshold_ = reader.finite();
    if (threshold_ < 0) reader.refuse("a threshold is below 0");
    // Counts that go on must not overflow: a run of additions is far from half of what fits, and the quiet
    // generations start again at the patience.
    run_ = static_cast<int>(reader.integer(0, largest / 2));
    quiet_ = static_cast<int>(reader.integer(0, parameters_.archive_patience - 1));
    length_ = static_cast<std::size_t>(reader.integer(0, largest));
    const std::size_t entries = reader.count(archive_entry_bytes(length_) + 8);
    if (length_ == 0 && entries > 0) reader.refuse("an archive has entries without behaviour");
    for (std::size_t i = 0; i < entries; ++i) {
        ArchiveEntry entry = load_archive_entry(reader, length_);
        add(std::move(entry), reader.finite());
    }
}

} // namespace planula
