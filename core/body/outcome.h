// SPDX-License-Identifier: MIT
// How the evaluation of an animat ended: results, not errors, counted in the data (§2.4, Eq. 6; rules D20, B7 and L4).
#pragma once

#include <array>

namespace planula {

enum class Outcome {
    viable,    // grew, settled and moved to the end
    died_out,  // no cell was left
    too_small, // fewer cells than Parameters::minimum_cells at the end of development, or left after damage
    overgrown, // Parameters::cell_limit was reached, even once
    never_settled, // not at rest within Parameters::settle_limit, or without room where it was to start
    exploded,      // a speed over node_speed_limit, or a number that is not finite
};

inline constexpr std::array<const char *, 6> outcome_names{"viable",    "died_out",      "too_small",
                                                           "overgrown", "never_settled", "exploded"};
inline const char *name_of(Outcome outcome) { return outcome_names[static_cast<int>(outcome)]; }

} // namespace planula
