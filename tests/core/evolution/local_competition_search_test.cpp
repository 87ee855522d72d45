// SPDX-License-Identifier: MIT
// The tests that every search passes are in search_test.cpp.
#include "evolution/local_competition_search.h"

#include "core/evolution/toy_run.h"

#include <boost/test/unit_test.hpp>

#include <set>
#include <vector>

using namespace planula;
using boost::test_tools::per_element;

namespace {

Parameters of(int population, int k) {
    Parameters parameters;
    parameters.neat.population = population;
    parameters.novelty.novelty_neighbours = k;
    return parameters;
}

} // namespace

BOOST_AUTO_TEST_CASE(competition_is_with_the_nearest_alive_or_archived) {
    // Two neighbours each. On a line: a at 0 fitness 5, b at 1 fitness 3, c at 3 fitness 4, d at 100 fitness 1,
    // e at 104 fitness 2; an archived one as fit as d at 101, f not valid.
    const Parameters parameters = of(6, 2);
    NoveltyArchive archive(parameters.novelty);
    const Population one = populations::of({{1}});
    archive.extend(one, std::vector<Evaluation>{{1, {101}, 1}}, std::vector<double>{9});
    BOOST_REQUIRE(archive.entries().size() == 1u);

    Innovations innovations(3);
    Elites pool;
    const std::vector<Evaluation> evaluations{{5, {0}, 1},   {3, {1}, 0.5}, {4, {3}, 1},
                                              {1, {100}, 1}, {2, {104}, 1}, {9, {2}, 0}};
    for (std::size_t i = 0; i < evaluations.size(); ++i)
        pool.add(populations::with_weight(static_cast<double>(i), innovations), evaluations[i]);
    const auto neighbours = archive.neighbours(pool.evaluations);
    const auto objectives = LocalCompetitionSearch(parameters).objectives(pool, neighbours, archive);

    // Novelty × penalty; beaten neighbours; mean δ = 1.5 · mean |Δw| to the four valid others.
    BOOST_TEST(objectives[0] == (Objectives{2, 2, 1.5 * (1 + 2 + 3 + 4) / 4}), per_element());    // b, c
    BOOST_TEST(objectives[1] == (Objectives{0.75, 0, 1.5 * (1 + 1 + 2 + 3) / 4}), per_element()); // a, c
    BOOST_TEST(objectives[2] == (Objectives{2.5, 1, 1.5 * (2 + 1 + 1 + 2) / 4}), per_element());  // b, a
    BOOST_TEST(objectives[3] == (Objectives{2.5, 0, 1.5 * (3 + 2 + 1 + 1) / 4}), per_element()); // archive, e
    BOOST_TEST(objectives[4] == (Objectives{3.5, 2, 1.5 * (4 + 3 + 2 + 1) / 4}), per_element()); // archive, d
    BOOST_TEST(objectives[5].empty());
}

BOOST_AUTO_TEST_CASE(competition_is_by_each_stated_objective) {
    using enum Objective::Value;
    using enum Objective::Goal;
    const Parameters parameters = of(3, 2);
    LocalCompetitionSearch search(parameters);
    BOOST_TEST(search.take({{{"work", stated, minimise}, {"fitness", fitness, maximise}}, {}}));
    NoveltyArchive archive(parameters.novelty);
    Innovations innovations(3);
    Elites pool;
    const std::vector<Evaluation> evaluations{{5, {0}, 1, {2}}, {3, {1}, 1, {1}}, {4, {3}, 1, {9}}};
    for (std::size_t i = 0; i < evaluations.size(); ++i)
        pool.add(populations::with_weight(static_cast<double>(i), innovations), evaluations[i]);
    const auto objectives = search.objectives(pool, archive.neighbours(pool.evaluations), archive);
    for (const Objectives &each : objectives) BOOST_TEST(each.size() == 4u);
    // The neighbours that it beats by less work, and those by more fitness.
    BOOST_TEST((objectives[0][1] == 1 && objectives[0][2] == 2));
    BOOST_TEST((objectives[1][1] == 2 && objectives[1][2] == 0));
    BOOST_TEST((objectives[2][1] == 0 && objectives[2][2] == 1));
}

BOOST_AUTO_TEST_CASE(within_a_front_the_most_distant_genotypes_come_first) {
    const std::vector<Objectives> objectives{{1, 2, 0.5}, {2, 1, 3}, {3, 0, 2}};
    const LocalCompetitionSearch search(of(3, 1));
    BOOST_TEST(search.diversity(objectives, std::vector{0, 2}) == (std::vector<double>{0.5, 2}),
               per_element());
}

BOOST_AUTO_TEST_CASE(a_niche_of_low_fitness_is_improved_although_others_are_fitter) {
    // Two plains: beyond 0 fitness is a hundredfold. Global competition would leave the poor one; here the
    // best of the poor plain comes near its optimum, too.
    const Judgement judge = [](const Genome &genome) {
        const double side = genome.links[0].weight, skill = genome.links[1].weight;
        return Evaluation{(side > 0 ? 100 : 1) * (8 - std::abs(skill - 4)) / 8, {side}, 1};
    };
    Parameters parameters = of(40, 8);
    parameters.neat.add_node_rate = parameters.neat.add_link_rate = parameters.neat.remove_link_rate = 0;
    parameters.neat.weight_power = 1;
    ToyRun run("nslc", parameters, 2, judge);
    const auto &search = dynamic_cast<const LocalCompetitionSearch &>(*run.search);
    run.steps(60);
    double poor = 0, rich = 0;
    for (const Evaluation &evaluation : search.kept().evaluations)
        (evaluation.behaviour[0] > 0 ? rich : poor) =
            std::max(evaluation.behaviour[0] > 0 ? rich : poor, evaluation.fitness);
    BOOST_TEST(rich > 95);
    BOOST_TEST(poor > 0.95);
}
