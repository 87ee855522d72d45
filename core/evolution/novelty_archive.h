// SPDX-License-Identifier: MIT
// The archive of novelty search and its use: neighbours in the space of behaviours (Lehman & Stanley 2011; §2.7.2;
// decision 0014). An invalid individual is as if it did not exist.
//
// The archive's threshold follows the pressure on it: a long unbroken run of additions raises it, a long time without
// any lowers it, never below its floor. The archive only grows.
#pragma once

#include "evolution/evaluation.h"
#include "evolution/nearest_neighbours.h"
#include "evolution/population.h"

#include <cstdint>
#include <span>
#include <vector>

namespace planula {

/// An individual in the archive.
struct ArchiveEntry {
    int generation = 0;
    std::int64_t genome = 0; // id
    std::vector<double> behaviour;
    double novelty = 0; // when it was added
    double fitness = 0;
    std::vector<double> objectives = {}; // as of Evaluation
    bool operator==(const ArchiveEntry &) const = default;
};

/// For a search that resumes: throws InputError at this place of its state unless there are `count` entries, each with
/// a behaviour of this length.
void check_archive(std::span<const ArchiveEntry> archive, std::size_t count, std::size_t length,
                   const StateReader &reader);

/// Eq. (7): the mean distance to these neighbours, summed in ascending order; 0 without any.
double novelty(std::span<const Neighbour> neighbours);

class NoveltyArchive {
  public:
    explicit NoveltyArchive(const NoveltyParameters &parameters)
        : parameters_(parameters), threshold_(parameters.archive_threshold) {}

    /// Of each individual the novelty_neighbours nearest among the valid others and the archive, the nearest first; all
    /// there are if they are fewer, and none for invalid individuals. An index below evaluations.size() is an
    /// individual; beyond that entries follow. Throws InputError as check_behaviours() does.
    std::vector<std::vector<Neighbour>> neighbours(std::span<const Evaluation> evaluations);

    /// Adds the individuals of a generation whose novelty is above the threshold.
    void extend(const Population &population, std::span<const Evaluation> evaluations,
                std::span<const double> novelty);

    std::span<const ArchiveEntry> entries() const { return entries_; }
    double threshold() const { return threshold_; }

    /// All but the entries.
    void save(StateWriter &writer) const;
    void load(StateReader &reader, std::span<const ArchiveEntry> entries);

  private:
    void add(ArchiveEntry entry);

    NoveltyParameters parameters_;
    std::vector<ArchiveEntry> entries_;
    PointIndex index_; // of their behaviours
    double threshold_;
    std::size_t length_ = 0; // of every behaviour of the run; 0 until the first is seen
    int run_ = 0;            // additions since the last valid individual that was not added
    int quiet_ = 0;          // generations since the last addition or fall of the threshold
};

} // namespace planula
