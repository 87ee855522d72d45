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

Conditions conditions(Actuation actuation, bool on_land) {
    Conditions c;
    c.parameters = turning();
    c.actuation = actuation;
    c.environment = on_land ? land() : water();
    c.actuation_range =
        on_land ? c.parameters.land.actuation_range_terrestrial : c.parameters.water.actuation_range_aquatic;
    return c;
}

Life simulated(const Genome &genome, Actuation actuation, bool on_land, const Watch &watch = {}) {
    return live(genome, conditions(actuation, on_land), watch);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_lump_with_muscles_grows_and_moves_in_all_four_settings) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const bool on_land : {false, true}) {
            const Life life = simulated(lump_genome(actuation, 6), actuation, on_land);
            BOOST_TEST(life.outcome == Outcome::viable);
            BOOST_TEST(life.cells >= 8);
            BOOST_TEST(life.displacement() > 0.01);
            BOOST_TEST(life.path.size() == 41u);
            BOOST_TEST((life.path.front() == life.rest));
            BOOST_TEST((life.path.back() == life.finish));
            BOOST_TEST((life.activity > 0) == (actuation == Actuation::grn));
            BOOST_TEST((life.settle_steps > 0) == on_land);
        }
}

BOOST_AUTO_TEST_CASE(development_alone_gives_what_the_whole_life_has_of_growth) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        const Genome genome = lump_genome(actuation, 6);
        const Life grown = develop(genome, conditions(actuation, true)),
                   whole = simulated(genome, actuation, true);
        BOOST_TEST((grown.outcome == Outcome::viable && grown.cells == whole.cells));
        BOOST_TEST((grown.largest == whole.largest && grown.births == whole.births));
        BOOST_TEST((grown.springs == whole.springs && grown.triangles == whole.triangles));
        BOOST_TEST(grown.elongation == whole.elongation);
        BOOST_TEST((grown.displacement() == 0 && grown.path.empty() && grown.settle_steps == 0));
    }
}

BOOST_AUTO_TEST_CASE(a_body_without_muscles_ends_where_it_starts) {
    // What nothing moves moves less than 4e-3 cells in 4000 steps; pressure is rounded at each corner of a triangle.
    Genome still = lump_genome(Actuation::grn, 6);
    std::erase_if(still.links,
                  [&](const LinkGene &link) { return link.to == still.inputs + output::spring; });
    const Life life = simulated(still, Actuation::grn, false);
    BOOST_TEST(life.outcome == Outcome::viable);
    BOOST_TEST(life.displacement() < 4e-3);
    BOOST_TEST(length(life.finish) < 4e-3);
    BOOST_TEST(life.activity == 0);
}

BOOST_AUTO_TEST_CASE(a_life_is_pure_on_every_thread_and_after_any_other) {
    std::vector<Genome> genomes;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) genomes.push_back(random_genome(Actuation::grn, seed));
    std::vector<Life> first(genomes.size()), second(genomes.size());
    for (std::size_t i = 0; i < genomes.size(); ++i) first[i] = simulated(genomes[i], Actuation::grn, true);
    parallel_for(static_cast<int>(genomes.size()), 3, [&](int i) {
        const std::size_t back = genomes.size() - 1 - static_cast<std::size_t>(i);
        second[back] = simulated(genomes[back], Actuation::grn, true);
    });
    for (std::size_t i = 0; i < genomes.size(); ++i) BOOST_TEST((first[i] == second[i]));
}

BOOST_AUTO_TEST_CASE(watching_changes_no_result_and_misses_no_step) {
    const Genome genome = lump_genome(Actuation::oscillator, 6);
    int grown = 0, born = 0, moved = 0;
    Vec2d last;
    Watch watch;
    watch.grow = [&](int, const Embryo &) { ++grown; };
    watch.born = [&](const Body &body) { born = body.cells(); };
    watch.move = [&](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
        BOOST_REQUIRE(step == moved++);
        BOOST_REQUIRE(nodes.size() == signal.size());
        last = centre_of_mass(nodes);
    };
    const Life watched = simulated(genome, Actuation::oscillator, false, watch);
    BOOST_TEST((watched == simulated(genome, Actuation::oscillator, false)));
    BOOST_TEST(grown == 601);
    BOOST_TEST(born == watched.cells);
    BOOST_TEST(moved == 4001);
    BOOST_TEST((last == watched.finish));
}

BOOST_AUTO_TEST_CASE(half_the_time_step_moves_a_body_nearly_as_far) {
    // Less than 2 % on fixed specimens.
    for (const bool on_land : {false, true}) {
        Conditions halved = conditions(Actuation::oscillator, on_land);
        const Genome genome = random_genome(Actuation::oscillator, 33);
        const Life whole = live(genome, halved);
        halved.refinement = 2;
        const Life half = live(genome, halved);
        BOOST_TEST(half.outcome == Outcome::viable);
        BOOST_TEST(half.cells == whole.cells);
        BOOST_TEST(half.path.size() == whole.path.size());
        BOOST_TEST(half.displacement() == whole.displacement(), boost::test_tools::tolerance(0.02));
        BOOST_TEST(half.displacement() != whole.displacement());
    }
}

BOOST_AUTO_TEST_CASE(other_engines_confirm_what_the_native_engine_finds) {
    for (const bool on_land : {false, true})
        for (const char *engine : {"reference", "bullet"}) {
            Conditions given = conditions(Actuation::oscillator, on_land);
            const Genome genome = random_genome(Actuation::oscillator, 33);
            const Life native = live(genome, given);
            given.engine = engine;
            const Life other = live(genome, given);
            const double bound = on_land && given.engine == "bullet" ? 0.1 : 0.001;
            BOOST_TEST(other.outcome == Outcome::viable, engine);
            BOOST_TEST(std::abs(other.rest.y - native.rest.y) < 0.02, engine); // in water both are 0
            BOOST_TEST(std::abs(other.displacement() / native.displacement() - 1) < bound,
                       engine << ": " << other.displacement() << ", native " << native.displacement());
            BOOST_TEST((other == live(genome, given)), engine);
        }
}

BOOST_AUTO_TEST_CASE(hostile_weights_end_in_a_named_outcome_and_finite_numbers) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        for (const double hostile : {1e300, -1e300, infinite, -infinite, nan}) {
            Genome genome = random_genome(Actuation::grn, seed);
            genome.links[seed % genome.links.size()].weight = hostile;
            const Life life = simulated(genome, Actuation::grn, true);
            BOOST_REQUIRE(is_finite(life.rest));
            BOOST_REQUIRE(is_finite(life.finish));
            BOOST_REQUIRE(std::isfinite(life.activity));
            BOOST_REQUIRE(std::isfinite(life.elongation));
        }
}

BOOST_AUTO_TEST_CASE(a_nudge_moves_every_node_a_little_and_depends_on_its_number) {
    const auto start = [](Nudge nudge) {
        Conditions nudged = conditions(Actuation::oscillator, false);
        nudged.nudge = nudge;
        std::vector<Vec2d> first;
        const auto keep_first = [&](int, std::span<const Vec2d> nodes, std::span<const double>) {
            if (first.empty()) first.assign(nodes.begin(), nodes.end());
        };
        live(lump_genome(Actuation::oscillator, 6), nudged,
             {.grow = {}, .born = {}, .move = keep_first, .update = {}});
        return first;
    };
    const auto still = start({}), one = start({0.01, 0}), again = start({0.01, 0}), two = start({0.01, 1});
    BOOST_REQUIRE(!still.empty());
    BOOST_TEST((one == again));
    for (std::size_t i = 0; i < still.size(); ++i) {
        BOOST_TEST(length(one[i] - still[i]) > 1e-5);
        BOOST_TEST(length(one[i] - still[i]) < 0.02);
        BOOST_TEST((one[i] != two[i]));
    }
}

BOOST_AUTO_TEST_CASE(a_life_with_phases_tells_what_it_did_in_each_world) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        Conditions given = conditions(actuation, false);
        given.parameters.gait.locomotion_steps = 600;
        given.phases = {{200, land(), 0.3, true}, {400, water(), 0.4, false}};
        BOOST_TEST(live(lump_genome(actuation, 6), given).observations.phase_start.empty());
        for (const Observation one : {Observation::phase_start, Observation::phase_finish,
                                      Observation::phase_steps, Observation::phase_settle_steps})
            given.observed.add(one);
        const Life life = live(lump_genome(actuation, 6), given);
        const Observations &told = life.observations;
        BOOST_TEST(life.outcome == Outcome::viable);
        BOOST_TEST(told.phase_steps == (std::vector<double>{200, 200, 200}));
        BOOST_TEST(life.settle_steps == 0);
        BOOST_TEST_REQUIRE(told.phase_settle_steps.size() == 3u);
        BOOST_TEST(told.phase_settle_steps[1] > 0);
        BOOST_TEST((told.phase_start.front() == life.rest));
        BOOST_TEST((told.phase_finish.back() == life.finish));
        given.refinement = 2;
        BOOST_TEST(live(lump_genome(actuation, 6), given).observations.phase_steps[1] == 400);
    }
}

BOOST_AUTO_TEST_CASE(a_damaged_body_moves_with_what_is_left) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const bool on_land : {false, true})
            for (const int at : {0, 200}) {
                Conditions given = conditions(actuation, on_land);
                given.parameters.gait.locomotion_steps = 400;
                given.damage = Damage{.at = at, .share = 0.4, .side = Side::right};
                std::vector<int> bodies;
                std::size_t nodes_at_end = 0;
                Watch watch;
                watch.born = [&](const Body &body) { bodies.push_back(body.cells()); };
                watch.move = [&](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
                    nodes_at_end = nodes.size();
                    BOOST_TEST(signal.size() == nodes.size());
                    BOOST_TEST(nodes.size() ==
                               static_cast<std::size_t>(step > at || at == 0 ? bodies.back() : bodies[0]));
                };
                const Life life = live(disc_genome(actuation), given, watch);
                BOOST_TEST(life.outcome == Outcome::viable);
                BOOST_TEST_REQUIRE(bodies.size() == 2u);
                BOOST_TEST(life.cells == bodies[0]);
                BOOST_TEST(bodies[1] <= 0.6 * bodies[0] + 1);
                BOOST_TEST(nodes_at_end == static_cast<std::size_t>(bodies[1]));
                BOOST_TEST((live(disc_genome(actuation), given) == life));
                BOOST_TEST((life.activity > 0) == (actuation == Actuation::grn));
            }
}

BOOST_AUTO_TEST_CASE(a_body_of_which_too_little_is_left_is_too_small) {
    Conditions given = conditions(Actuation::oscillator, false);
    for (const int at : {0, 200}) {
        given.damage = Damage{.at = at, .share = 0.95};
        const Life life = live(disc_genome(Actuation::oscillator), given);
        BOOST_TEST(life.outcome == Outcome::too_small);
        BOOST_TEST(life.cells > 50);
        BOOST_TEST(life.displacement() == 0);
    }
}

BOOST_AUTO_TEST_CASE(what_a_life_tells_is_of_what_is_left_of_the_body) {
    Conditions given = conditions(Actuation::oscillator, true);
    given.parameters.gait.locomotion_steps = 600;
    given.damage = Damage{.at = 400, .share = 0.4, .side = Side::right};
    given.phases = {{200, water(), 0.4, false}};
    for (std::size_t one = 0; one < observation_rows().size(); ++one)
        given.observed.add(static_cast<Observation>(one));
    const Life life = live(disc_genome(Actuation::oscillator), given);
    BOOST_TEST_REQUIRE(life.outcome == Outcome::viable);
    const Observations &told = life.observations;
    BOOST_TEST(told.body.size() == static_cast<std::size_t>(life.cells));
    BOOST_TEST(told.final_shape.size() < told.body.size());
    BOOST_TEST(told.signals.front().size() == told.body.size());
    BOOST_TEST(told.signals.back().size() == told.final_shape.size());
    BOOST_TEST(told.contact_time > 0.1);
    BOOST_TEST(told.contact_time < 0.4);
    BOOST_TEST(told.work > 0);
}
