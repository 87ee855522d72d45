// SPDX-License-Identifier: MIT
#include "experiment/run.h"

#include "base/error.h"
#include "core/experiment/swimmers.h"
#include "evaluation/live.h"
#include "experiment/signature.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>
#include <string_view>

using namespace planula;

namespace {

Spec small(std::string_view search, Actuation actuation = Actuation::oscillator) {
    return swimmers(search, actuation, 12, 400);
}

std::string signature(const Spec &spec, std::uint64_t seed, int threads) {
    Signature hash;
    run(spec, seed, threads, [&](const Generation &generation) { hash.observe(generation); });
    return hash.hex();
}

/// The signature of a run in which every individual is simulated, known or not.
std::string signature_without_memo(const Spec &spec, std::uint64_t seed) {
    Signature hash;
    RunState state = begin(spec, seed);
    Population &population = state.population;
    for (;;) {
        std::vector<Life> lives;
        for (const Genome &genome : population.genomes) lives.push_back(live(genome, spec));
        const std::vector<Evaluation> evaluations = judge_all(spec.judge, lives);
        const std::vector<double> scores = state.search->score(population, evaluations);
        const auto less = [](const Evaluation &a, const Evaluation &b) { return a.fitness < b.fitness; };
        const auto best =
            std::max_element(evaluations.begin(), evaluations.end(), less) - evaluations.begin();
        hash.observe({population.generation,
                      population,
                      lives,
                      evaluations,
                      scores,
                      *state.search,
                      state.mothers,
                      static_cast<int>(best),
                      {}});
        if (population.generation + 1 == spec.parameters.design.generations) return hash.hex();
        population = state.search->next(population, scores, shape_of(spec.actuation), seed);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(a_run_is_a_function_of_its_seed_for_any_number_of_threads) {
    std::set<std::string> signatures;
    for (const std::string_view search : search_names()) {
        const std::string one = signature(small(search), 1, 1);
        BOOST_TEST(signatures.insert(one).second); // every search goes its own way
        for (const int threads : {2, 7}) BOOST_TEST(signature(small(search), 1, threads) == one);
        BOOST_TEST(signature(small(search), 2, 2) != one);
    }
}

BOOST_AUTO_TEST_CASE(every_generation_is_observed_once_and_complete) {
    const Spec spec = small("neat", Actuation::grn);
    int expected = 0;
    run(spec, 3, 2, [&](const Generation &generation) {
        BOOST_TEST(generation.number == expected++);
        BOOST_TEST(generation.population.genomes.size() == 12u);
        BOOST_TEST(generation.lives.size() == 12u);
        BOOST_TEST(generation.scores.size() == 12u);
        for (const Evaluation &e : generation.evaluations)
            BOOST_TEST(e.fitness <= generation.evaluations[generation.best].fitness);
        std::set<int> slots;
        for (const Species &species : generation.population.species)
            slots.insert(species.members.begin(), species.members.end());
        BOOST_TEST(slots.size() == 12u);
    });
    BOOST_TEST(expected == 4);
}

BOOST_AUTO_TEST_CASE(the_best_fitness_never_falls_when_fitness_is_searched) {
    // Each species breeds an unchanged copy of its champion, and evaluation is pure.
    Spec spec = small("neat");
    spec.parameters.neat.population = 20;
    spec.parameters.design.generations = 6;
    double best = 0;
    run(spec, 5, 2, [&](const Generation &generation) {
        const double now = generation.evaluations[generation.best].fitness;
        BOOST_TEST(now >= best);
        best = now;
    });
    BOOST_TEST(best > 0);
}

BOOST_AUTO_TEST_CASE(a_run_with_and_without_the_memo_is_equal) {
    for (const std::string_view search : search_names())
        BOOST_TEST(signature(small(search), 9, 2) == signature_without_memo(small(search), 9));
    const Spec grn = small("neat", Actuation::grn);
    BOOST_TEST(signature(grn, 9, 2) == signature_without_memo(grn, 9));
}

BOOST_AUTO_TEST_CASE(champions_of_the_generation_before_are_known) {
    for (const int threads : {1, 3}) {
        int known = 0;
        run(small("neat"), 9, threads, [&](const Generation &generation) {
            BOOST_TEST((generation.known.lives > 0) == (generation.number > 0));
            known += generation.known.lives;
        });
        BOOST_TEST(known < 4 * 12);
    }
}

BOOST_AUTO_TEST_CASE(a_request_to_stop_ends_the_run) {
    int generations = 0;
    BOOST_CHECK_THROW(run(
                          small("neat"), 1, 2, [&](const Generation &) { ++generations; },
                          [&] { return generations == 2; }),
                      Stopped);
    BOOST_TEST(generations == 2);
}

BOOST_AUTO_TEST_CASE(a_judgement_that_is_not_finite_is_an_internal_error) {
    Spec spec = small("neat");
    spec.judge = [](const Life &) { return Evaluation{-1, {0, 0}, 1}; };
    BOOST_CHECK_THROW(run(spec, 1, 1, [](const Generation &) {}), InternalError);
}
