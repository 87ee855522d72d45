// SPDX-License-Identifier: MIT
// What each input and each output of the control network means (§2.2, 2.3, 2.6; rules N1 and N2). The two actuations
// share the inputs and the first four outputs.
#pragma once

#include <array>
#include <cstddef>

namespace planula {

enum class Actuation { oscillator, grn };

inline const char *name_of(Actuation actuation) {
    return actuation == Actuation::oscillator ? "oscillator" : "grn";
}

namespace input {
enum Channel { x, y, maternal_east, maternal_west, maternal_north, maternal_south, morphogen, time, bias };
inline constexpr int count = bias + 1;
inline constexpr std::array<const char *, count> names{
    "x",         "y",    "maternal east", "maternal west", "maternal north", "maternal south",
    "morphogen", "time", "bias"};
} // namespace input

namespace output {
enum Channel {
    division_inhibitor,
    division_angle,
    apoptosis,
    morphogen,
    period,     // oscillator only
    phase,      // oscillator only
    spring = 4, // grn only: the actuation signal s
};
inline constexpr int count(Actuation actuation) { return actuation == Actuation::oscillator ? 6 : 5; }
/// The name of a channel, below count(actuation).
inline const char *name_of(Actuation actuation, int channel) {
    constexpr std::array oscillator{"division inhibitor", "division angle", "apoptosis",
                                    "morphogen",          "period",         "phase"};
    if (actuation == Actuation::grn && channel == spring) return "spring";
    return oscillator.at(static_cast<std::size_t>(channel));
}
} // namespace output

/// Feed-forward networks are stateless and acyclic; those of the GRN may be recurrent and keep their state.
inline constexpr bool is_recurrent(Actuation actuation) { return actuation == Actuation::grn; }

} // namespace planula
