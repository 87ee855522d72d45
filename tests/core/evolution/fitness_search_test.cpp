// SPDX-License-Identifier: MIT
#include "evolution/fitness_search.h"

#include "base/error.h"
#include "core/evolution/populations.h"
#include "evolution/reproduce.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(the_score_is_the_fitness_as_judged_and_zero_for_the_invalid) {
    Population population;
    population.genomes.resize(3);
    FitnessSearch search{Parameters()};
    // The penalty is already in the fitness and must not count twice.
    const std::vector<Evaluation> evaluations{{4, {}, 1}, {2, {}, 0.1}, {9, {}, 0}};
    BOOST_TEST(search.score(population, evaluations) == (std::vector<double>{4, 2, 0}),
               boost::test_tools::per_element());
    BOOST_TEST(search.archive().empty());
    BOOST_TEST(search.archive_threshold() == 0);
}

BOOST_AUTO_TEST_CASE(the_next_generation_is_that_of_neat_with_shared_scores) {
    const Population population = populations::far_apart({6, 2});
    const std::vector<double> scores{3, 3, 3, 3, 3, 3, 1, 1};
    const Parameters parameters = populations::frozen(8);
    const Population next = FitnessSearch(parameters).next(population, scores, {2, 1, false}, 4);
    BOOST_TEST((next.genomes ==
                reproduce(population, scores, Adjustment::sharing, false, parameters.neat, 4).genomes));
    BOOST_TEST(populations::sizes(next) == (std::vector<int>{6, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(its_saved_state_is_its_name) {
    const Population population;
    StateWriter writer;
    FitnessSearch(Parameters()).save(population, writer);
    StateReader reader(writer.bytes());
    FitnessSearch(Parameters()).load(population, {}, reader);
    reader.done();
    StateReader short_of_one(std::string_view(writer.bytes()).substr(1));
    BOOST_CHECK_THROW(FitnessSearch(Parameters()).load(population, {}, short_of_one), InputError);
}

BOOST_AUTO_TEST_CASE(fitness_that_is_not_a_number_is_an_internal_error) {
    Population population;
    population.genomes.resize(1);
    FitnessSearch search{Parameters()};
    for (const double fitness : {-1.0, std::numeric_limits<double>::quiet_NaN()})
        BOOST_CHECK_THROW(search.score(population, std::vector<Evaluation>{{fitness, {}, 1}}), InternalError);
    BOOST_CHECK_THROW(search.score(population, {}), InternalError);
}
