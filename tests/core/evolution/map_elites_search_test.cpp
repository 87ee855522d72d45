// SPDX-License-Identifier: MIT
// The tests that every search passes are in search_test.cpp.
#include "evolution/map_elites_search.h"

#include "base/error.h"
#include "core/evolution/toy_run.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numeric>
#include <vector>

using namespace planula;
using boost::test_tools::per_element;

namespace {

Parameters of(int population, double width) {
    Parameters parameters;
    parameters.neat.population = population;
    parameters.map_elites.niche_width = width;
    return parameters;
}

} // namespace

BOOST_AUTO_TEST_CASE(each_niche_keeps_its_fittest_and_scores_are_what_they_add) {
    // Niches two wide: (0, 0), (0, −1), (0, 0) again and fitter, (1, 0), not valid, (0, −1) equally fit.
    MapElitesSearch search(of(6, 2));
    const auto scores = search.score(numbered(6, 0), std::vector<Evaluation>{{3, {0, 0}, 1},
                                                                             {1, {1.9, -0.1}, 1},
                                                                             {5, {1.5, 1.5}, 1},
                                                                             {2, {2, 0}, 1},
                                                                             {9, {8, 8}, 0},
                                                                             {1, {0, -2}, 1}});
    BOOST_TEST(scores == (std::vector<double>{3, 1, 2, 2, 0, 0}), per_element());
    BOOST_TEST(ids(search.elites()) == (Ids{2, 1, 3}), per_element());
    BOOST_TEST(search.archive().size() == 4u);
    BOOST_TEST(search.archive()[2].genome == 2);
    BOOST_TEST(search.archive()[2].novelty == 2);

    // The next generation: worse than the elite, better than it, and an empty niche with nothing to show.
    const auto later = search.score(
        numbered(3, 6), std::vector<Evaluation>{{4, {1, 1}, 1}, {1.5, {1, -1}, 0.1}, {0, {-1, -1}, 1}});
    BOOST_TEST(later == (std::vector<double>{0, 0.5, 0}), per_element());
    BOOST_TEST(ids(search.elites()) == (Ids{2, 7, 3, 8}), per_element());
    BOOST_TEST(search.archive().size() == 6u);

    // The QD-score is the sum of all that was added: 5 + 1.5 + 2 + 0.
    double sum = 0;
    for (const ArchiveEntry &entry : search.archive()) sum += entry.novelty;
    BOOST_TEST(sum == 8.5);
}

BOOST_AUTO_TEST_CASE(stated_ranges_bound_the_map) {
    MapElitesSearch search(of(2, 1));
    BOOST_TEST(search.take({{}, {{"size", 0, 10, 2}, {"turn", -1, 1, 4}}}));
    // In the first niche three times, the last of them from below both ranges; and in the last, from above.
    search.score(
        numbered(5, 0),
        std::vector<Evaluation>{
            {1, {4, -0.9}, 1}, {2, {0, -1}, 1}, {3, {-7, -50}, 1}, {1, {10, 1}, 1}, {2, {1e9, 0.51}, 1}});
    BOOST_TEST(ids(search.elites()) == (Ids{2, 4}), per_element());
    BOOST_CHECK_THROW(search.score(numbered(1, 5), std::vector<Evaluation>{{1, {1}, 1}}), InputError);

    MapElitesSearch other(of(2, 1));
    other.take({{}, {{"size", 0, 10, 2}}});
    BOOST_CHECK_THROW(other.score(numbered(1, 0), std::vector<Evaluation>{{1, {1, 2}, 1}}), InputError);
    BOOST_CHECK_THROW(other.take({{}, {{"size", 0, 10, 2}, {"turn"}}}), InputError);
    BOOST_TEST(!other.take({{{"work"}}, {}}));
    // Names alone leave the grid as it is.
    MapElitesSearch grid(of(2, 1));
    BOOST_TEST(grid.take({{}, {{"size"}, {"turn"}}}));
    grid.score(numbered(2, 0), std::vector<Evaluation>{{1, {400, 3}, 1}, {1, {401, 3}, 1}});
    BOOST_TEST(grid.elites().size() == 2u);
}

BOOST_AUTO_TEST_CASE(zero_is_one_edge_from_either_side) {
    MapElitesSearch search(of(2, 1));
    search.score(numbered(2, 0), std::vector<Evaluation>{{1, {-0.0}, 1}, {2, {0.0}, 1}});
    BOOST_TEST(search.elites().size() == 1u);
}

BOOST_AUTO_TEST_CASE(parents_are_drawn_uniformly_from_the_elites) {
    Parameters parameters = populations::frozen(6000);
    MapElitesSearch search(parameters);
    std::vector<Evaluation> evaluations;
    for (int i = 0; i < 6; ++i)
        evaluations.push_back({i == 0 ? 0.0 : 10.0 * i, {i / 2 * 1.0}, 1}); // three niches
    const Population population = numbered(6, 0);
    const auto scores = search.score(population, evaluations);
    std::vector<int> children(6);
    for (const Genome &genome : search.next(population, scores, {2, 1, false}, 1).genomes)
        ++children[genome.mother];
    for (const int loser : {0, 2, 4}) BOOST_TEST(children[loser] == 0);
    for (const int elite : {1, 3, 5}) BOOST_TEST(std::abs(children[elite] - 2000) < 150);
}

BOOST_AUTO_TEST_CASE(without_elites_parents_are_drawn_from_the_population) {
    MapElitesSearch search(populations::frozen(300));
    const Population population = numbered(3, 0);
    const auto scores = search.score(population, std::vector<Evaluation>(3));
    std::vector<int> children(3);
    for (const Genome &genome : search.next(population, scores, {2, 1, false}, 1).genomes)
        ++children[genome.mother];
    for (const int count : children) BOOST_TEST(count > 50);
}

BOOST_AUTO_TEST_CASE(a_known_map_is_covered_and_its_score_approached) {
    // A weight in [−8, 8] is the behaviour; fitness is the distance of another weight from −8. There are 32
    // niches half a unit wide and the edge at 8, each worth 16 at most.
    const Judgement judge = [](const Genome &genome) {
        return Evaluation{8 + genome.links[1].weight, {genome.links[0].weight}, 1};
    };
    Parameters parameters = of(50, 0.5);
    parameters.neat.add_node_rate = parameters.neat.add_link_rate = parameters.neat.remove_link_rate = 0;
    parameters.neat.weight_power = 1;
    parameters.neat.crossover_rate = 0; // every child is mutated
    ToyRun run("map-elites", parameters, 1, judge);
    const auto &search = dynamic_cast<const MapElitesSearch &>(*run.search);
    double before = 0;
    for (int generation = 0; generation < 120; ++generation) {
        run.step();
        double score = 0;
        for (const Evaluation &evaluation : search.elites().evaluations) score += evaluation.fitness;
        BOOST_TEST(score >= before);
        before = score;
    }
    BOOST_TEST(search.elites().size() == 33u);
    BOOST_TEST(before > 0.97 * 33 * 16);
    BOOST_TEST(before <= 33.0 * 16);
}

BOOST_AUTO_TEST_CASE(a_map_that_cannot_be_is_refused) {
    const Population population = numbered(1, 0);
    const auto refused = [&](const std::vector<Evaluation> &evaluations, int length) {
        Elites elites;
        for (const Evaluation &evaluation : evaluations) {
            elites.genomes.push_back(population.genomes.front());
            elites.evaluations.push_back(evaluation);
        }
        StateWriter writer;
        writer.group("map-elites search");
        save(elites, population.innovations, writer);
        writer.group("archive").integer(length).integer(0);
        StateReader reader(writer.bytes());
        MapElitesSearch search(of(2, 1));
        BOOST_CHECK_THROW(search.load(population, {}, reader), InputError);
    };
    refused({{1, {0.2}, 1}, {1, {0.7}, 1}}, 1); // two in a niche
    refused({{1, {0.2}, 0}}, 1);                // not valid
    refused({{1, {}, 1}}, 0);
    refused({{1, {1, 2}, 1}}, 1);
    refused({}, -1);
}
