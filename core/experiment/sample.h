// SPDX-License-Identifier: MIT
// Which individuals a run records. A run recorded in full keeps a row of every individual: some 45 MB compressed for
// the paper's 2000 generations of 300. One recorded as a sample keeps a random part that suffices for figures and
// claims: one in a hundred, and of a shorter run as many more as make a thousand, or another number that the experiment
// states. Each individual has a lot, drawn from
// a stream of its own, and is in the sample of a run if its lot is below that run's share. A run
// does not know how long it will become, so generation g records all that would be in the sample of a run that ended
// with g; those in the sample of a longer run are among them.
#pragma once

#include "base/random.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace planula {

/// The share of all individuals that the sample holds at least.
inline constexpr double recorded_share = 0.01;
/// The individuals that the sample of a short run holds on average, unless the experiment states another number.
inline constexpr int recorded_least = 1000;
inline constexpr int recorded_most = 1'000'000'000;

/// `share`, or of fewer individuals as much more as makes `least` on average; at most 1.
inline double sample_share(double share, int least, int population, int generations) {
    return std::min(1.0, std::max(share, least / (static_cast<double>(population) * generations)));
}

/// How much of a run is recorded; no part of its results.
struct Recording {
    bool full = true;           // every individual, or a sample
    int least = recorded_least; // the individuals that the sample of a short run holds on average

    /// The share of a run of this length that is in its sample, which a run recorded in full contains.
    double share(int population, int generations) const {
        return sample_share(recorded_share, least, population, generations);
    }
    friend bool operator==(const Recording &, const Recording &) = default;
};
inline constexpr Recording full_record{}, sample_record{.full = false};

/// As identity.csv and manifest.csv have it: "full", "sample", or "sample of 300" with another number than
/// recorded_least.
std::string name_of(const Recording &record);
/// The record of that name; nothing if there is none.
std::optional<Recording> record_of(std::string_view name);

/// An individual's lot, in [0, 1).
inline double lot(std::uint64_t seed, int generation, int slot) {
    return Stream(seed, static_cast<std::uint32_t>(generation), static_cast<std::uint32_t>(slot),
                  Purpose::sampling)
        .uniform();
}

/// Whether a run recorded as such a sample has a row of this individual.
inline bool is_in_sample(const Recording &record, std::uint64_t seed, int population, int generation,
                         int slot) {
    return lot(seed, generation, slot) < record.share(population, generation + 1);
}

} // namespace planula
