// SPDX-License-Identifier: MIT
// What evolution reads of an individual: its genome and evaluation, nothing of the animat.
#pragma once

#include "base/state.h"

#include <cstddef>
#include <span>
#include <vector>

namespace planula {

struct Evaluation {
    double fitness = 0;            // the objective, >= 0 and finite; in novelty search only recorded
    std::vector<double> behaviour; // the descriptor; the same length for every valid individual of a run
    double penalty = 0;            // p of Eq. 6, in [0, 1]; 0: the individual is not valid
    std::vector<double> objectives =
        {}; // those that the experiment states (evolution/aims.h); empty without any

    bool valid() const { return penalty > 0; }
    bool operator==(const Evaluation &) const = default;
};

/// For searches that read descriptors: throws InputError if a valid individual has none, one that is not finite, or one
/// of another length than `length`, which the first one sets while it is 0.
void check_behaviours(std::span<const Evaluation> evaluations, std::size_t &length);

/// All but the objectives, which searches that read them save themselves.
void save(const Evaluation &evaluation, StateWriter &writer);
/// Throws InputError unless a sound evaluation comes next.
Evaluation load_evaluation(StateReader &reader);

} // namespace planula
