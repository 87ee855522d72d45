// SPDX-License-Identifier: MIT
// Evolved individuals that come with the program, for trying out scripts on real lives: champions of the tracked runs,
// of both actuations, from water and from land, small and large. They are in specimens.csv of the library (the
// `experiments` folder), in the columns of champion_genomes.csv.gz; `make specimens` takes them from the runs.
#pragma once

#include "evaluation/conditions.h"
#include "tables/genome_table.h"

#include <filesystem>
#include <vector>

namespace planula {

/// The genomes of this actuation, in the order of the file. Throws InputError that names the file if it is missing,
/// damaged, or holds none that fits this program.
std::vector<Genome> specimens(const std::filesystem::path &library, Actuation actuation);

} // namespace planula
