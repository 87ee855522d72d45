// SPDX-License-Identifier: MIT
#include "evaluation/observations.h"

#include "evaluation/conditions.h"

#include <iterator>

namespace planula {

namespace {

constexpr Existence with_phases{[](const Conditions &conditions) { return !conditions.phases.empty(); },
                                "in settings with phases"};
constexpr Existence with_object{
    [](const Conditions &conditions) { return conditions.environment.object.cells() > 0; },
    "in environments with an object"};

constexpr ObservationRow rows[] = {
#define OBSERVATION(type, name, initial, unit, known, exists, meaning)                                       \
    {#name, unit, meaning, KnownAfter::known, exists},
#include "evaluation/observations.inl"
};
static_assert(std::size(rows) <= 64, "an ObservationSet has 64 bits");

} // namespace

std::span<const ObservationRow> observation_rows() { return rows; }

} // namespace planula
