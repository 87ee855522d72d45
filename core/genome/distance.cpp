// SPDX-License-Identifier: MIT
#include "genome/distance.h"

#include "genome/align.h"

#include <algorithm>
#include <cmath>

namespace planula {

double distance(const Genome &a, const Genome &b, const Parameters &parameters) {
    int excess_links = 0, disjoint_links = 0, matching_links = 0;
    double difference = 0;
    align(
        a, b,
        [&](const LinkGene &of_a, const LinkGene &of_b) {
            ++matching_links;
            difference += std::abs(of_a.weight - of_b.weight);
        },
        [&](const LinkGene &, Side, bool excess) { ++(excess ? excess_links : disjoint_links); });
    const double mean_difference = matching_links > 0 ? difference / matching_links : 0;
    return parameters.excess_coefficient * excess_links + parameters.disjoint_coefficient * disjoint_links +
           parameters.weight_coefficient * mean_difference;
}

bool is_clone(const Genome &genome, std::span<const Genome> others, const Parameters &parameters) {
    return std::any_of(others.begin(), others.end(), [&](const Genome &other) {
        return other.links.size() == genome.links.size() &&
               distance(genome, other, parameters) < parameters.clone_distance;
    });
}

} // namespace planula
