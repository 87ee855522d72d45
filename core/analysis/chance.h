// SPDX-License-Identifier: MIT
// Probability that the analysis needs beside core/statistics.
#pragma once

#include <cstdint>
#include <string_view>

namespace planula {

/// P(X >= marked) for X the marked ones among `drawn` out of `total`, of which `all_marked` are marked.
double hypergeometric_tail(int marked, int total, int all_marked, int drawn);

/// A seed for a bootstrap that depends on what the interval is of and on nothing else.
std::uint64_t bootstrap_seed(std::string_view what);

} // namespace planula
