// SPDX-License-Identifier: MIT
// How far apart two genomes are: δ = excess + disjoint + 1.5 · mean |Δw| of the matching links, with the coefficients
// of the parameters and *not* divided by the size of the genomes (§2.7.1; decision 0013). It decides which genomes
// share a species, which may mate, and which count as clones.
#pragma once

#include "genome/genome.h"
#include "parameters/parameters.h"

#include <span>
#include <vector>

namespace planula {

/// δ; symmetric, 0 from a genome to itself. Genomes without a common link differ by their links alone.
double distance(const Genome &a, const Genome &b, const NeatParameters &parameters);

/// Of each genome, Σ δ to all others from first to last: the bits of distance(), by what each link has in common with
/// the same link of those before, several times as fast.
std::vector<double> distance_sums(std::span<const Genome *const> genomes, const NeatParameters &parameters);

/// Whether one of `others` has as many links as this genome and a distance below clone_distance.
bool is_clone(const Genome &genome, std::span<const Genome> others, const NeatParameters &parameters);

} // namespace planula
