// SPDX-License-Identifier: MIT
// Evolved individuals live on a device as on this processor, to the bit, with both actuations, in water and on land.
#include "experiment/spec.h"
#include "statement/specimens.h"
#include "support/device_lives.h"
#include "support/scripts.h"
#include "tables/columns.h"
#include "tables/genome_table.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

/// The best individuals of the tracked runs with this actuation.
std::vector<Genome> best_genomes(Actuation actuation) {
    std::vector<std::vector<GenomeRow>> rows;
    std::string last;
    for (const auto &row : read_table<BestGenomeRow>(std::filesystem::path(PLANULA_SOURCE_DIR) / "data")) {
        const std::string name = row.setting + std::to_string(row.rank);
        if (name != last) rows.emplace_back();
        last = name;
        rows.back().push_back({row.kind, row.id, row.from, row.to, row.value, row.recurrent});
    }
    std::vector<Genome> genomes;
    const NetworkShape shape = shape_of(actuation);
    for (const std::vector<GenomeRow> &each : rows)
        if (Genome genome = genome_of(each); genome.inputs == shape.inputs && genome.outputs == shape.outputs)
            genomes.push_back(std::move(genome));
    return genomes;
}

/// In water and on land. Returns how many lives moved a body.
int compare_in_both_worlds(const std::vector<Genome> &genomes, Actuation actuation) {
    int moved = 0;
    for (const Environment &environment : {Environment{.drag_normal = 1.0, .drag_tangential = 0.1},
                                           Environment{.gravity = 5, .has_ground = true, .friction = 0.8}})
        moved += compare_lives(genomes, short_life(actuation, environment));
    return moved;
}

} // namespace

BOOST_AUTO_TEST_CASE(evolved_individuals_live_on_a_device_as_here) {
    int moved = 0;
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        moved += compare_in_both_worlds(specimens(experiments_folder(), actuation), actuation);
    BOOST_TEST(moved > 10);
}

BOOST_AUTO_TEST_CASE(the_best_of_the_tracked_runs_live_on_a_device_as_here) {
    int moved = 0;
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        moved += compare_in_both_worlds(best_genomes(actuation), actuation);
    BOOST_TEST(moved > 20);
}
