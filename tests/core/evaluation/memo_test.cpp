// SPDX-License-Identifier: MIT
#include "evaluation/memo.h"

#include "base/parallel.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace planula;
using namespace planula::specimens;

namespace {

Conditions conditions(Actuation actuation) {
    Conditions c;
    c.actuation = actuation;
    c.environment = land();
    c.actuation_range = c.parameters.land.actuation_range_terrestrial;
    c.parameters.gait.locomotion_steps = 400;
    return c;
}

/// Simulates a generation, each life of which must be what live() gives; how many were known.
Known known_of(Memo &memo, const std::vector<Genome> &genomes, const Conditions &given, int threads = 1) {
    memo.begin_generation(static_cast<int>(genomes.size()));
    std::vector<Life> lives(genomes.size());
    parallel_for(static_cast<int>(genomes.size()), threads,
                 [&](int slot) { lives[slot] = memo.live(slot, genomes[slot]); });
    for (std::size_t i = 0; i < genomes.size(); ++i) BOOST_TEST((lives[i] == live(genomes[i], given)));
    return memo.known();
}

/// The same genome with other names and another past.
Genome renamed(Genome genome) {
    genome.id = 77, genome.mother = 3, genome.father = 4, genome.origin = Origin::champion;
    for (LinkGene &link : genome.links) link.innovation += 100;
    return genome;
}

/// The same animat from another genome: a hidden node that nothing listens to.
Genome with_idle_node(Genome genome) {
    const int id = genome.inputs + genome.outputs;
    genome.nodes.push_back({id, NodeKind::hidden, 0.5});
    add_link(genome, input::x, id, 1);
    return genome;
}

Genome with_last_weight(Genome genome, double weight) {
    genome.links.back().weight = weight;
    return genome;
}

} // namespace

BOOST_AUTO_TEST_CASE(an_equal_genome_is_known_under_any_id_and_another_is_not) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        const Conditions given = conditions(actuation);
        const Genome lump = lump_genome(actuation, 6), dead = bare_genome(actuation);
        Memo memo(given);
        BOOST_TEST(known_of(memo, {lump, dead}, given).lives == 0);
        const Known known =
            known_of(memo, {renamed(dead), renamed(lump), with_last_weight(lump, 0.5)}, given);
        BOOST_TEST(known.lives == 2);
        BOOST_TEST(known.movements == 0);
    }
}

BOOST_AUTO_TEST_CASE(an_equal_body_with_equal_oscillators_moves_as_known) {
    const Conditions given = conditions(Actuation::oscillator);
    const Genome lump = lump_genome(Actuation::oscillator, 6);
    Memo memo(given);
    known_of(memo, {lump}, given);
    // The last link of the lump sets its phases: an equal body that moves in another way.
    const Known known = known_of(memo, {with_idle_node(lump), with_last_weight(lump, -5)}, given);
    BOOST_TEST(known.lives == 0);
    BOOST_TEST(known.movements == 1);
    BOOST_TEST(live(with_last_weight(lump, -5), given).cells == live(lump, given).cells);
}

BOOST_AUTO_TEST_CASE(networks_as_muscles_are_known_by_the_genome_alone) {
    const Conditions given = conditions(Actuation::grn);
    const Genome lump = lump_genome(Actuation::grn, 6);
    Memo memo(given);
    known_of(memo, {lump}, given);
    const Known known = known_of(memo, {with_last_weight(lump, -2.5), with_idle_node(lump)}, given);
    BOOST_TEST((known.lives == 0 && known.movements == 0));
}

BOOST_AUTO_TEST_CASE(one_generation_is_remembered_with_the_results_that_it_took_from_the_one_before) {
    const Conditions given = conditions(Actuation::oscillator);
    const Genome lump = lump_genome(Actuation::oscillator, 6), line = line_genome(Actuation::oscillator, 5);
    Memo memo(given);
    known_of(memo, {lump, line}, given);
    BOOST_TEST(known_of(memo, {lump}, given).lives == 1);
    const Known known = known_of(memo, {line, lump, with_idle_node(lump)}, given);
    BOOST_TEST(known.lives == 1);
    BOOST_TEST(known.movements == 1);
}

BOOST_AUTO_TEST_CASE(known_individuals_do_not_depend_on_threads) {
    const Conditions given = conditions(Actuation::oscillator);
    std::vector<Genome> first, second;
    for (int i = 0; i < 8; ++i) {
        first.push_back(with_last_weight(lump_genome(Actuation::oscillator, 5), i % 4));
        second.push_back(with_last_weight(lump_genome(Actuation::oscillator, 5), i % 6));
    }
    Memo memo(given);
    BOOST_TEST(known_of(memo, first, given, 3).lives == 0); // equals of one generation do not see each other
    BOOST_TEST(known_of(memo, second, given, 3).lives == 6);
}

BOOST_AUTO_TEST_CASE(a_known_movement_has_the_phases_and_the_damage_of_the_conditions) {
    Conditions given = conditions(Actuation::oscillator);
    given.phases = {{200, water(), 0.4, false}};
    given.damage = Damage{.at = 100, .share = 0.3, .side = Side::left};
    const Genome disc = disc_genome(Actuation::oscillator);
    given.observed.add(Observation::phase_finish);
    Memo memo(given);
    known_of(memo, {disc}, given);
    BOOST_TEST(known_of(memo, {with_idle_node(disc)}, given).movements == 1);
    BOOST_TEST(live(disc, given).observations.phase_finish.size() == 2u);
}

BOOST_AUTO_TEST_CASE(what_a_known_movement_tells_is_remembered_with_it) {
    Conditions given = conditions(Actuation::oscillator);
    given.observed.add(Observation::work);
    given.observed.add(Observation::body);
    given.observed.add(Observation::signals);
    const Genome lump = lump_genome(Actuation::oscillator, 6);
    Memo memo(given);
    known_of(memo, {lump}, given);
    const Known known = known_of(memo, {with_idle_node(lump), renamed(lump)}, given);
    BOOST_TEST((known.lives == 1 && known.movements == 1));
}
