// SPDX-License-Identifier: MIT
#include "browser/random_lives.h"

#include "support/hostile.h"

namespace planula::test {

std::optional<RandomLife> random_life(int number) {
    const Conditions conditions = specimens::short_life(number % 4);
    Genome genome = specimens::hostile_genome(conditions.actuation, static_cast<std::uint32_t>(number / 4));
    for (const LinkGene &link : genome.links)
        if (!std::isfinite(link.weight)) return std::nullopt;
    return RandomLife{std::move(genome), conditions};
}

} // namespace planula::test
