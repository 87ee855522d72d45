// SPDX-License-Identifier: MIT
// The parameters that the benchmarks are run with: MultiNEAT's, and those that the benchmarks were published with as
// far as planula's parameters can express them.
//
// The publications' networks use the sigmoid 1/(1 + exp(−4.9 x)) = (1 + tanh(2.45 x))/2, ours tanh x: their weights
// correspond to ours divided by 2.45. What cannot be expressed is listed in README.md beside this file.
#pragma once

#include "parameters/parameters.h"

#include <string_view>

namespace planula::benchmark {

struct Settings {
    std::string_view name;
    Parameters parameters;
};

/// The defaults of MultiNEAT at the revision that the paper names: those of planula except the scale of weights at the
/// start and of their mutations, and the rounding of weights.
Settings multineat_settings();
/// Stanley & Miikkulainen (2002), section 4 and appendix A: 150 networks, or 1000 with other rates for two poles
/// without velocities.
Settings stanley_settings(bool large);
/// Lehman & Stanley (2011), from the parameter file published with their program.
Settings lehman_settings();

} // namespace planula::benchmark
