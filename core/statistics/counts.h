// SPDX-License-Identifier: MIT
// Probabilities of counts, exact up to rounding: of how many runs have a property.
#pragma once

namespace planula {

/// P(X >= marked) for X the marked ones among `drawn` out of `total`, of which `all_marked` are marked: R's
/// phyper(marked - 1, all_marked, total - all_marked, drawn, lower.tail = FALSE).
double hypergeometric_tail(int marked, int total, int all_marked, int drawn);

/// P(X <= found) for X the successes among `count` trials of the same probability in [0, 1]: R's pbinom(found, count,
/// probability).
double binomial_lower_tail(int found, int count, double probability);

} // namespace planula
