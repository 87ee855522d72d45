// SPDX-License-Identifier: MIT
#include "evolution/novelty_archive.h"

#include "base/check.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace planula {

void check_archive(std::span<const ArchiveEntry> archive, std::size_t count, std::size_t length,
                   const StateReader &reader) {
    if (archive.size() != count)
        reader.refuse("its archive has " + to_text(static_cast<std::int64_t>(count)) + " entries, and not " +
                      to_text(static_cast<std::int64_t>(archive.size())));
    for (const ArchiveEntry &entry : archive)
        if (entry.behaviour.empty() || entry.behaviour.size() != length)
            reader.refuse("an entry of the archive has a behaviour of another length");
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
        NearestNeighbours nearest(parameters_.novelty_neighbours);
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
        add({population.generation, population.genomes[slot].id, evaluations[slot].behaviour, novelty[slot],
             evaluations[slot].fitness, evaluations[slot].objectives});
        if (run_ > parameters_.archive_run) threshold_ *= parameters_.archive_raise;
    }

    // After a long time without additions the threshold falls, and the count starts again.
    quiet_ = added_any ? 0 : quiet_ + 1;
    if (quiet_ < parameters_.archive_patience) return;
    threshold_ = std::max(parameters_.archive_floor, threshold_ * parameters_.archive_lower);
    quiet_ = 0;
}

void NoveltyArchive::add(ArchiveEntry entry) {
    index_.add(entry.behaviour);
    entries_.push_back(std::move(entry));
}

void NoveltyArchive::save(StateWriter &writer) const {
    writer.group("archive").real(threshold_).integer(run_).integer(quiet_);
    writer.integer(static_cast<std::int64_t>(length_)).integer(static_cast<std::int64_t>(entries_.size()));
}

void NoveltyArchive::load(StateReader &reader, std::span<const ArchiveEntry> entries) {
    constexpr int largest = std::numeric_limits<int>::max();
    *this = NoveltyArchive(parameters_);
    reader.group("archive");
    threshold_ = reader.finite();
    if (threshold_ < 0) reader.refuse("a threshold is below 0");
    // Counts that go on must not overflow: a run of additions is far from half of what fits, and the quiet generations
    // start again at the patience.
    run_ = static_cast<int>(reader.integer(0, largest / 2));
    quiet_ = static_cast<int>(reader.integer(0, parameters_.archive_patience - 1));
    length_ = static_cast<std::size_t>(reader.integer(0, largest));
    check_archive(entries, static_cast<std::size_t>(reader.integer(0, largest)), length_, reader);
    for (const ArchiveEntry &entry : entries) add(entry);
}

} // namespace planula
