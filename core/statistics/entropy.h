// SPDX-License-Identifier: MIT
// The Shannon entropy of body sizes, the paper's proxy of morphological diversity (Eq. (8), §3.6).
#pragma once

#include <cstdint>
#include <span>

namespace planula {

/// H = −Σ p(s) ln p(s) over the distinct values s, with p(s) the share of s among `values`. In nats; 0 if all
/// values are equal and without values, at most the logarithm of the number of distinct values.
double entropy(std::span<const int> values);

/// The same from how often each distinct value occurs. Counts are at least 0; those of 0 add nothing.
double entropy_of_counts(std::span<const std::int64_t> counts);

} // namespace planula
