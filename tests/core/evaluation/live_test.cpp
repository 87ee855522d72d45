// SPDX-License-Identifier: MIT
#include "evaluation/live.h"

#include "base/parallel.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace planula;
using namespace planula::specimens;

namespace {

Life lived(const Genome &genome, Actuation actuation, bool on_land, const Watch &watch = {}) {
    const Parameters p;
    return live(genome, actuation, on_land ? p.actuation_range_terrestrial : p.actuation_range_aquatic,
                on_land ? land() : water(), p, watch);
}

bool equal(const Life &a, const Life &b) {
    return a.outcome == b.outcome && a.cells == b.cells && a.rest == b.rest && a.end == b.end &&
           a.activity == b.activity && a.path == b.path && a.elongation == b.elongation;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_lump_that_beats_grows_and_moves_in_all_four_settings) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const bool on_land : {false, true}) {
            const Life life = lived(lump_genome(actuation, 6), actuation, on_land);
            BOOST_TEST(life.outcome == Outcome::viable);
            BOOST_TEST(life.cells >= 8);
            BOOST_TEST(life.displacement() > 0.01);
            BOOST_TEST(life.path.size() == 41u);
            BOOST_TEST((life.path.front() == life.rest));
            BOOST_TEST((life.path.back() == life.end));
            BOOST_TEST((life.activity > 0) == (actuation == Actuation::grn));
            BOOST_TEST((life.settle_steps > 0) == on_land);
        }
}

BOOST_AUTO_TEST_CASE(a_body_without_muscles_ends_where_it_starts) {
    Genome still = lump_genome(Actuation::grn, 6);
    std::erase_if(still.links,
                  [&](const LinkGene &link) { return link.to == still.inputs + output::spring; });
    const Life life = lived(still, Actuation::grn, false);
    BOOST_TEST(life.outcome == Outcome::viable);
    BOOST_TEST(life.displacement() < 1e-4);
    BOOST_TEST(length(life.end) < 1e-4);
    BOOST_TEST(life.activity == 0);
}

BOOST_AUTO_TEST_CASE(a_life_is_pure_on_every_thread_and_after_any_other) {
    std::vector<Genome> genomes;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) genomes.push_back(random_genome(Actuation::grn, seed));
    std::vector<Life> first(genomes.size()), second(genomes.size());
    for (std::size_t i = 0; i < genomes.size(); ++i) first[i] = lived(genomes[i], Actuation::grn, true);
    parallel_for(static_cast<int>(genomes.size()), 3, [&](int i) {
        const std::size_t back = genomes.size() - 1 - static_cast<std::size_t>(i);
        second[back] = lived(genomes[back], Actuation::grn, true);
    });
    for (std::size_t i = 0; i < genomes.size(); ++i) BOOST_TEST(equal(first[i], second[i]));
}

BOOST_AUTO_TEST_CASE(watching_changes_nothing_and_sees_everything) {
    const Genome genome = lump_genome(Actuation::oscillator, 6);
    int grown = 0, born = 0, moved = 0;
    Vec2d last;
    Watch watch;
    watch.grow = [&](int, auto, auto) { ++grown; };
    watch.born = [&](const Body &body) { born = body.cells(); };
    watch.move = [&](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
        BOOST_REQUIRE(step == moved++);
        BOOST_REQUIRE(nodes.size() == signal.size());
        last = centre_of_mass(nodes);
    };
    const Life watched = lived(genome, Actuation::oscillator, false, watch);
    BOOST_TEST(equal(watched, lived(genome, Actuation::oscillator, false)));
    BOOST_TEST(grown == 601);
    BOOST_TEST(born == watched.cells);
    BOOST_TEST(moved == 4001);
    BOOST_TEST((last == watched.end));
}

BOOST_AUTO_TEST_CASE(hostile_weights_end_in_a_named_outcome_and_finite_numbers) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        for (const double hostile : {1e300, -1e300, infinite, -infinite, nan}) {
            Genome genome = random_genome(Actuation::grn, seed);
            genome.links[seed % genome.links.size()].weight = hostile;
            const Life life = lived(genome, Actuation::grn, true);
            BOOST_REQUIRE(is_finite(life.rest));
            BOOST_REQUIRE(is_finite(life.end));
            BOOST_REQUIRE(std::isfinite(life.activity));
            BOOST_REQUIRE(std::isfinite(life.elongation));
        }
}
