// SPDX-License-Identifier: MIT
// A genome as rows of a table, and back to the same bits: first its origin and parents, then its nodes, then
// its links, each in the genome's own order. What comes from a file is refused unless check_genome accepts
// it.
#pragma once

#include "genome/genome.h"
#include "record/columns.h"

#include <span>
#include <vector>

namespace planula {

std::vector<GenomeRow> genome_rows(const Genome &genome);

/// Throws InputError naming the broken rule; the caller knows the file.
Genome genome_of(std::span<const GenomeRow> rows);

/// The genomes of a population, in slot order, and back; errors as above.
std::vector<PopulationRow> population_rows(std::span<const Genome> genomes);
std::vector<Genome> population_of(std::span<const PopulationRow> rows);

} // namespace planula
