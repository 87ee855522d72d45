// SPDX-License-Identifier: MIT
// Where the random streams of the analysis begin.
#pragma once

#include <cstdint>
#include <string_view>

namespace planula {

/// A seed for a bootstrap or a permutation test that depends on what it is of and on nothing else.
std::uint64_t bootstrap_seed(std::string_view what);

} // namespace planula
