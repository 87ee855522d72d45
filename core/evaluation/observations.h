// SPDX-License-Identifier: MIT
// What a life tells beside its fields, only to those who ask: evaluation/observations.inl says what each observation
// holds. Nothing here knows how they are computed (evaluation/life_observer.h).
#pragma once

#include "base/vec2.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace planula {

struct Conditions;

/// A list of numbers at each of several times.
using Samples = std::vector<std::vector<double>>;

/// The stage that a body must have passed before something of its life is known.
enum class KnownAfter { growth, locomotion };

/// Which settings have an observation: all, or those for which `holds`. `where` says so in a message, "in …".
struct Existence {
    bool (*holds)(const Conditions &conditions) = nullptr;
    std::string_view where;
};
inline constexpr Existence everywhere;

enum class Observation {
#define OBSERVATION(type, name, initial, unit, known, exists, meaning) name,
#include "evaluation/observations.inl"
};

struct ObservationRow {
    std::string_view name, unit, meaning;
    KnownAfter known;
    Existence exists;
};

/// All of them, in the order of the list; the place of one is its Observation.
std::span<const ObservationRow> observation_rows();

/// Some of the observations.
class ObservationSet {
  public:
    bool has(Observation one) const { return (bits_ & bit(one)) != 0; }
    void add(Observation one) { bits_ |= bit(one); }
    bool empty() const { return bits_ == 0; }
    bool operator==(const ObservationSet &) const = default;

  private:
    static std::uint64_t bit(Observation one) { return std::uint64_t{1} << static_cast<int>(one); }
    std::uint64_t bits_ = 0;
};

/// The observations of a life: those of `known`, and the initial values of all others.
struct Observations {
    ObservationSet known;
#define OBSERVATION(type, name, initial, unit, stage, exists, meaning) type name = initial;
#include "evaluation/observations.inl"
    bool operator==(const Observations &) const = default;
};

/// Calls visit(observation, value) for each of the set, in the order of the list.
template <class Values, class Visit>
void each_observation(const ObservationSet &set, Values &values, Visit &&visit) {
#define OBSERVATION(type, name, initial, unit, known, exists, meaning)                                       \
    if (set.has(Observation::name)) visit(Observation::name, values.name);
#include "evaluation/observations.inl"
}

} // namespace planula
