// SPDX-License-Identifier: MIT
// The native engine computes what the reference engine says, for bodies that evolved.
#include "support/lockstep_life.h"

#include "support/specimens.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <map>
#include <string>

using namespace planula;
using namespace planula::specimens;

namespace {

const std::filesystem::path root = PLANULA_SOURCE_DIR;

/// The best champion of each setting in the tracked runs, by its name; none without data.
std::map<std::string, Genome> champions() {
    std::map<std::string, std::vector<GenomeRow>> rows;
    if (std::filesystem::exists(root / "data" / BestGenomeRow::file_name))
        for (const BestGenomeRow &row : read_table<BestGenomeRow>(root / "data"))
            if (row.rank == 1)
                rows[row.setting].push_back({row.kind, row.id, row.from, row.to, row.value, row.recurrent});
    std::map<std::string, Genome> genomes;
    for (const auto &[setting, genes] : rows) genomes[setting] = genome_of(genes);
    return genomes;
}

/// Grows and moves it for 1500 steps.
void check(const std::string &name, const Genome &genome, const Conditions &given) {
    Conditions conditions = given;
    conditions.parameters.gait.locomotion_steps = 1500;
    Lockstep lockstep;
    BOOST_TEST(move(genome, conditions, lockstep), name);
    BOOST_TEST_MESSAGE(name << ": " << lockstep.steps << " steps, touching in " << lockstep.touching
                            << ", off by " << lockstep.position_error << " cells and "
                            << lockstep.velocity_error << " cells/t.u.");
    BOOST_TEST(lockstep.exploded_alike, name);
    BOOST_TEST(lockstep.position_error < rounding_bound(conditions.environment).position, name);
    BOOST_TEST(lockstep.velocity_error < rounding_bound(conditions.environment).velocity, name);
}

} // namespace

BOOST_AUTO_TEST_CASE(each_step_of_a_champion_is_that_of_the_reference_engine) {
    for (const auto &[setting, genome] : champions()) {
        const bool swims = setting.find("-aq-") != std::string::npos;
        Conditions conditions{.actuation =
                                  setting.starts_with("osc") ? Actuation::oscillator : Actuation::grn,
                              .environment = swims ? water() : land()};
        const Parameters &p = conditions.parameters;
        conditions.actuation_range =
            swims ? p.water.actuation_range_aquatic : p.land.actuation_range_terrestrial;
        check(setting, genome, conditions);
    }
}

BOOST_AUTO_TEST_CASE(each_step_of_a_body_pressed_on_itself_is_that_of_the_reference_engine) {
    for (const char *name : {"arch", "knot"}) {
        Conditions conditions{.actuation = Actuation::grn, .environment = water()};
        conditions.parameters = turning(); // as when they were champions
        conditions.actuation_range = conditions.parameters.water.actuation_range_aquatic;
        check(name, genome_of(read_table<GenomeRow>(root / "tests/golden/tremblers" / name)), conditions);
    }
}
