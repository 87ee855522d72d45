// SPDX-License-Identifier: MIT
#include "analysis/chance.h"

#include "base/hash.h"

#include <charconv>
#include <string>

namespace planula {

std::uint64_t bootstrap_seed(std::string_view what) {
    constexpr std::size_t digits = 16;
    const std::string hex = sha256(what).substr(0, digits);
    std::uint64_t seed = 0;
    std::from_chars(hex.data(), hex.data() + digits, seed, 16);
    return seed;
}

} // namespace planula
