// SPDX-License-Identifier: MIT
// The tests that every search passes are in search_test.cpp.
#include "evolution/nsga2_search.h"

#include "base/error.h"
#include "core/evolution/toy_run.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace planula;
using boost::test_tools::per_element;

namespace {

Parameters of(int population, int k = 1) {
    Parameters parameters;
    parameters.neat.population = population;
    parameters.novelty.novelty_neighbours = k;
    return parameters;
}

/// Two functions to be minimised.
Aims both() {
    using enum Objective::Value;
    using enum Objective::Goal;
    return {{{"first", stated, minimise}, {"second", stated, minimise}}, {}};
}

double sum_of(const Genome &genome) {
    double sum = 0;
    for (const LinkGene &link : genome.links) sum += link.weight;
    return sum;
}

/// SCH: x² and (x − 2)², whose front is 0 … 2 (Schaffer 1985; Deb et al. 2002, table I).
Evaluation schaffer(const Genome &genome) {
    const double x = sum_of(genome);
    return {0, {x}, 1, {x * x, (x - 2) * (x - 2)}};
}

/// ZDT1 of as many variables as there are weights (Zitzler, Deb & Thiele 2000): each is half a weight without its
/// sign, at most 1. On the front all but the first are 0, and f2 = 1 − √f1.
Evaluation zdt1(const Genome &genome) {
    const auto variable = [&](std::size_t i) { return std::min(1.0, std::abs(genome.links[i].weight) / 2); };
    double sum = 0;
    for (std::size_t i = 1; i < genome.links.size(); ++i) sum += variable(i);
    const double g = 1 + 9 * sum / static_cast<double>(genome.links.size() - 1), first = variable(0);
    return {0, {first}, 1, {first, g * (1 - std::sqrt(first / g))}};
}

} // namespace

BOOST_AUTO_TEST_CASE(the_objectives_are_fitness_and_penalised_novelty) {
    Elites pool;
    pool.add(Genome(), {7, {0}, 0.5});
    pool.add(Genome(), {3, {4}, 1});
    pool.add(Genome(), {9, {4}, 0});
    const std::vector<std::vector<Neighbour>> neighbours{{{4, 1}, {16, 3}}, {{4, 0}}, {}};
    const auto objectives = Nsga2Search(of(3)).objectives(pool, neighbours, NoveltyArchive(of(3).novelty));
    BOOST_TEST(objectives[0] == (Objectives{7, 1.5}), per_element()); // (2 + 4) / 2 · 0.5
    BOOST_TEST(objectives[1] == (Objectives{3, 2}), per_element());
    BOOST_TEST(objectives[2].empty());
}

BOOST_AUTO_TEST_CASE(parents_and_children_compete_by_front_then_by_crowding) {
    // Novelty by one neighbour on a line. Generation 0: at 0, 1, 5, fitness 1, 3, 2: novelty 1, 1, 4. Fronts
    // {1, 2}, {0}; within the first both are ends, and equals keep their order.
    Nsga2Search search(of(3));
    const auto scores =
        search.score(numbered(3, 0), std::vector<Evaluation>{{1, {0}, 1}, {3, {1}, 1}, {2, {5}, 1}});
    BOOST_TEST(ids(search.kept()) == (Ids{1, 2, 0}), per_element());
    BOOST_TEST(scores == (std::vector<double>{0, 2, 1}), per_element());
    BOOST_TEST(search.archive().size() == 3u); // each is novel enough

    // Generation 1: at 5, 20, none; fitness 9, 2. All three old ones and the archive are neighbours: the old
    // ones are at their own entries, novelty 0; so does the first child; the second has 15. Fronts: {3, 4},
    // then fitness alone: {1}, {2}, {0}; who is not valid comes last.
    const auto later = search.score(numbered(3, 3), std::vector<Evaluation>{{9, {5}, 1}, {2, {20}, 1}, {}});
    BOOST_TEST(ids(search.kept()) == (Ids{3, 4, 1}), per_element());
    BOOST_TEST(later == (std::vector<double>{5, 4, 0}), per_element());
    BOOST_TEST(search.archive().size() == 4u); // the one at 20; old ones do not enter again
}

BOOST_AUTO_TEST_CASE(the_crowded_of_the_last_front_are_dropped) {
    // One front, fitness falling as novelty rises, and those of fitness 0 behind it.
    Parameters parameters = of(4);
    parameters.novelty.archive_threshold = 1e6;
    Nsga2Search search(parameters);
    // Pairs on a line; the distance within a pair is the novelty: 1, 2, 2.5, 10.
    std::vector<Evaluation> pairs;
    double x = 0;
    for (const auto &[apart, fitness] : {std::pair{1.0, 10.0}, {2.0, 9.0}, {2.5, 8.5}, {10.0, 1.0}}) {
        pairs.push_back({fitness, {x}, 1});
        pairs.push_back({0, {x + apart}, 1});
        x += 100;
    }
    search.score(numbered(8, 0), pairs);
    // Crowding of slot 2: 1.5/9 + 1.5/9; of slot 4: 8/9 + 8/9.
    BOOST_TEST(ids(search.kept()) == (Ids{0, 6, 4, 2}), per_element());
}

BOOST_AUTO_TEST_CASE(binary_tournaments_prefer_the_higher_rank) {
    // Of n, the one at place i from 0 wins (2 (n − i) − 1) / n² of all tournaments; there is no mating here.
    Parameters parameters = populations::frozen(4000);
    parameters.novelty.novelty_neighbours = 1;
    Nsga2Search search(parameters);
    std::vector<Evaluation> evaluations;
    for (int i = 0; i < 4; ++i) evaluations.push_back({10.0 - i, {0}, 1});
    const Population population = numbered(4, 0);
    const auto scores = search.score(population, evaluations);
    BOOST_TEST(ids(search.kept()) == (Ids{0, 1, 2, 3}), per_element());
    std::vector<int> children(4);
    for (const Genome &genome : search.next(population, scores, {2, 1, false}, 1).genomes)
        ++children[genome.mother];
    for (int i = 0; i < 4; ++i) BOOST_TEST(std::abs(children[i] - 4000 * (7 - 2 * i) / 16) < 130);
}

BOOST_AUTO_TEST_CASE(the_front_of_a_known_problem_is_approached_and_kept) {
    // Behaviour is the sum of weights, and fitness falls with its square: the fittest stand still, the novel
    // go far. No generation loses the fittest.
    const Judgement judge = [](const Genome &genome) {
        double sum = 0;
        for (const LinkGene &link : genome.links) sum += link.weight;
        return Evaluation{100 / (1 + sum * sum), {sum}, 1};
    };
    ToyRun run("nsga2", of(40, 5), 1, judge);
    const auto &search = dynamic_cast<const Nsga2Search &>(*run.search);
    double best = 0, widest = 0;
    for (int generation = 0; generation < 40; ++generation) {
        run.step();
        double now = 0;
        for (const Evaluation &evaluation : search.kept().evaluations) {
            now = std::max(now, evaluation.fitness);
            widest = std::max(widest, std::abs(evaluation.behaviour[0]));
        }
        BOOST_TEST(now >= best);
        best = now;
    }
    BOOST_TEST(best > 99.9);
    BOOST_TEST(widest > 5);
}

BOOST_AUTO_TEST_CASE(stated_objectives_take_the_place_of_fitness_and_novelty) {
    Aims aims = both();
    aims.objectives.push_back({"novelty", Objective::Value::novelty, Objective::Goal::maximise});
    Nsga2Search search(of(3));
    BOOST_TEST(search.take(aims));
    Elites pool;
    pool.add(Genome(), {7, {0}, 0.5, {3, -4}});
    pool.add(Genome(), {3, {4}, 0, {}});
    const auto objectives = search.objectives(pool, {{{4, 1}}, {}}, NoveltyArchive(of(3).novelty));
    BOOST_TEST(objectives[0] == (Objectives{-3, 4, 1}), per_element());
    BOOST_TEST(objectives[1].empty());
}

BOOST_AUTO_TEST_CASE(the_front_of_schaffers_problem_is_found_and_spread_over) {
    ToyRun run("nsga2", of(40, 5), 1, schaffer, both());
    run.steps(40);
    std::vector<double> front;
    for (const Evaluation &evaluation : dynamic_cast<const Nsga2Search &>(*run.search).kept().evaluations)
        front.push_back(evaluation.behaviour[0]);
    std::sort(front.begin(), front.end());
    BOOST_TEST(front.size() == 40u);
    BOOST_TEST(front.front() > -0.02);
    BOOST_TEST(front.front() < 0.1);
    BOOST_TEST(front.back() > 1.9);
    BOOST_TEST(front.back() < 2.02);
    double widest = 0;
    for (std::size_t i = 1; i < front.size(); ++i) widest = std::max(widest, front[i] - front[i - 1]);
    BOOST_TEST(widest < 0.2);
}

BOOST_AUTO_TEST_CASE(the_front_of_zdt1_is_found) {
    Parameters parameters = of(60, 5);
    parameters.neat.add_node_rate = parameters.neat.add_link_rate = parameters.neat.remove_link_rate = 0;
    ToyRun run("nsga2", parameters, 1, zdt1, both());
    run.steps(100);
    double above = 0, least = 1, most = 0;
    const Elites &kept = dynamic_cast<const Nsga2Search &>(*run.search).kept();
    for (const Evaluation &evaluation : kept.evaluations) {
        const double first = evaluation.objectives[0];
        above += (evaluation.objectives[1] - (1 - std::sqrt(first))) / static_cast<double>(kept.size());
        least = std::min(least, first), most = std::max(most, first);
    }
    BOOST_TEST(above < 0.05);
    BOOST_TEST(above > -1e-9); // nothing lies beyond the front
    BOOST_TEST(least < 0.05);
    BOOST_TEST(most > 0.8);
}

BOOST_AUTO_TEST_CASE(a_search_with_objectives_resumes_as_if_it_had_not_been_stopped) {
    ToyRun through("nsga2", of(20, 5), 5, schaffer, both()), stopped("nsga2", of(20, 5), 5, schaffer, both());
    through.steps(4);
    stopped.steps(4);
    StateWriter writer;
    stopped.search->save(stopped.population, writer);
    const std::vector<ArchiveEntry> archive(stopped.search->archive().begin(),
                                            stopped.search->archive().end());
    BOOST_TEST(archive.front().objectives.size() == 2u);
    stopped.search = make_search("nsga2", stopped.parameters, both());
    StateReader reader(writer.bytes());
    stopped.search->load(stopped.population, archive, reader);
    reader.done();
    BOOST_TEST((stopped.steps(6) == through.steps(6)));
    // The state of a run without objectives is another one.
    const auto other = make_search("nsga2", stopped.parameters);
    StateReader again(writer.bytes());
    BOOST_CHECK_THROW(other->load(stopped.population, archive, again), InputError);
}

BOOST_AUTO_TEST_CASE(an_objective_that_is_no_number_is_refused) {
    ToyRun run(
        "nsga2", of(4, 1), 1,
        [](const Genome &) {
            return Evaluation{1, {0}, 1, {1, std::numeric_limits<double>::quiet_NaN()}};
        },
        both());
    BOOST_CHECK_THROW(run.step(), InputError);
}
