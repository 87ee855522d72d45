// SPDX-License-Identifier: MIT
// Whether a gait is cyclic, or a single movement and a long glide (§3.1, decision 0015): in the last quarter of
// locomotion the body must still move on, and its muscles must still change.
#pragma once

#include "evaluation/life.h"
#include "parameters/parameters.h"

namespace planula {

/// The least share that the last quarter of a cyclic gait has of both; an even rhythm has a quarter.
inline constexpr double cyclic_level = 0.1;

/// The distance made in the last quarter of locomotion over the displacement; 0 without one.
double late_share(const Life &life, const GaitParameters &gait);

/// `late_actuation`: the share that the last quarter has of all changes of muscle signals (Life::late_actuation).
bool is_cyclic(double late_share, double late_actuation, double level = cyclic_level);

} // namespace planula
