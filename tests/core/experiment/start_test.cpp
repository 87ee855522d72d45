// SPDX-License-Identifier: MIT
#include "experiment/start.h"

#include "base/error.h"
#include "evaluation/live.h"
#include "experiment/run.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <set>
#include <string>

using namespace planula;

namespace {

/// Bodies are distinguished by their number of cells; `lives` counts those judged.
Spec with_start(int generations, int *lives = nullptr, Actuation actuation = Actuation::oscillator) {
    Spec spec;
    spec.name = "start";
    spec.actuation = actuation;
    spec.actuation_range = spec.parameters.water.actuation_range_aquatic;
    spec.environment = specimens::water();
    spec.parameters.neat.population = 24;
    spec.parameters.design.generations = 2;
    spec.parameters.gait.locomotion_steps = 200;
    spec.judge = [](const Life &life) {
        return Evaluation{life.displacement(), {life.finish.x}, life.outcome == Outcome::viable ? 1.0 : 0.0};
    };
    spec.start.emplace();
    spec.start->generations = generations;
    spec.start->judge = [lives](const Life &life) {
        if (lives) ++*lives;
        BOOST_TEST_REQUIRE((life.path.empty() && life.displacement() == 0));
        return Evaluation{0, {life.cells / 16.0}, life.outcome == Outcome::viable ? 1.0 : 0.0};
    };
    return spec;
}

Population first_of(const Spec &spec, std::uint64_t seed, int threads = 1) {
    return first_population(spec, seed, threads, [] { return false; });
}

int sizes_in(const Population &population, const Spec &spec) {
    std::set<int> sizes;
    for (const Genome &genome : population.genomes)
        if (const Life life = develop(genome, spec); life.outcome == Outcome::viable)
            sizes.insert(life.cells);
    return static_cast<int>(sizes.size());
}

} // namespace

BOOST_AUTO_TEST_CASE(without_a_start_generation_0_is_random) {
    Spec spec = with_start(3);
    spec.start.reset();
    const Population random = initial_population(shape_of(spec.actuation), spec.parameters.neat, 4);
    BOOST_TEST((first_of(spec, 4).genomes == random.genomes));
}

BOOST_AUTO_TEST_CASE(generation_0_is_complete_and_has_no_ancestors) {
    int lives = 0;
    const Spec spec = with_start(6, &lives);
    const Population first = first_of(spec, 1);
    BOOST_TEST(lives == 6 * 24);
    BOOST_TEST(first.generation == 0);
    BOOST_TEST(first.next_genome == 24);
    BOOST_TEST(first.threshold == spec.parameters.neat.compatibility_threshold);
    BOOST_REQUIRE(first.genomes.size() == 24u);
    std::set<std::int64_t> ids;
    int mutated = 0;
    for (const Genome &genome : first.genomes) {
        check_genome(genome);
        ids.insert(genome.id);
        BOOST_TEST((genome.mother == -1 && genome.father == -1 && genome.origin == Origin::initial));
        for (const LinkGene &link : genome.links) {
            mutated += std::abs(link.weight) > 1; // no first weight is
            BOOST_TEST_REQUIRE(link.innovation < first.innovations.links());
        }
    }
    BOOST_TEST(mutated > 0);
    BOOST_TEST((ids.size() == 24u && *ids.rbegin() == 23));
    int members = 0;
    for (const Species &species : first.species) {
        BOOST_TEST((species.age == 0 && species.best_ever == 0));
        members += static_cast<int>(species.members.size());
    }
    BOOST_TEST(members == 24);
}

BOOST_AUTO_TEST_CASE(bodies_become_more_diverse) {
    const Spec spec = with_start(8);
    int before = 0, after = 0;
    for (const std::uint64_t seed : {1, 2}) {
        after += sizes_in(first_of(spec, seed), spec);
        before += sizes_in(initial_population(shape_of(spec.actuation), spec.parameters.neat, seed), spec);
    }
    BOOST_TEST(after > before);
}

BOOST_AUTO_TEST_CASE(generation_0_is_a_function_of_its_seed_for_any_number_of_threads) {
    const Spec spec = with_start(3, nullptr, Actuation::grn);
    const auto one = first_of(spec, 1).genomes;
    BOOST_TEST((first_of(spec, 1, 3).genomes == one));
    BOOST_TEST((first_of(spec, 2).genomes != one));
}

BOOST_AUTO_TEST_CASE(a_run_begins_with_the_generation_that_was_evolved) {
    const Spec spec = with_start(2);
    const auto first = first_of(spec, 5).genomes;
    run(spec, 5, 2, [&](const Generation &generation) {
        BOOST_TEST((generation.population.genomes == first) == (generation.number == 0));
    });
}

BOOST_AUTO_TEST_CASE(a_request_to_stop_ends_the_start_too) {
    BOOST_CHECK_THROW(first_population(with_start(3), 1, 2, [] { return true; }), Stopped);
}
