// SPDX-License-Identifier: MIT
// Rules of NEAT and of novelty search (decisions 0013 and 0014) that show over several generations,
// worked by hand, and whole populations that must keep them.
#include "core/evolution/populations.h"
#include "evolution/novelty_search.h"
#include "evolution/reproduce.h"
#include "genome/distance.h"
#include "genome/mutate.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace planula;
using boost::test_tools::per_element;
using populations::far_apart;
using populations::frozen;
using populations::sizes;

namespace {

const Species &find(const Population &population, int id) {
    const auto found = std::find_if(population.species.begin(), population.species.end(),
                                    [&](const Species &species) { return species.id == id; });
    BOOST_TEST_REQUIRE((found != population.species.end()));
    return *found;
}

/// The next generation if all members of species `id` score score_of[id]; children are copies.
Population after(const Population &population, const std::vector<double> &score_of,
                 const Parameters &parameters) {
    std::vector<double> scores(population.genomes.size());
    for (const Species &species : population.species)
        for (const int member : species.members) scores[member] = score_of[species.id];
    return reproduce(population, scores, Adjustment::sharing, false, parameters.neat, 1);
}

/// Whether links can be followed for ever.
bool has_cycle(const Genome &genome) {
    // Nodes without a way in are taken away with their links until none is left, or only cycles are.
    std::vector<LinkGene> links = genome.links;
    std::vector<int> nodes;
    for (const NodeGene &node : genome.nodes) nodes.push_back(node.id);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const int id = nodes[i];
            if (std::any_of(links.begin(), links.end(), [&](const LinkGene &link) { return link.to == id; }))
                continue;
            std::erase_if(links, [&](const LinkGene &link) { return link.from == id; });
            nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(i--));
            changed = true;
        }
    }
    return !links.empty();
}

} // namespace

BOOST_AUTO_TEST_CASE(numbers_of_the_library_are_those_of_multineat) {
    const Parameters p;
    BOOST_TEST(p.neat.compatibility_threshold == 5);
    BOOST_TEST(p.neat.compatibility_floor == 0.2);
    BOOST_TEST(p.neat.compatibility_step == 0.2);
    BOOST_TEST(p.neat.species_low == 5);
    BOOST_TEST(p.neat.species_high == 10);
    BOOST_TEST(p.neat.disjoint_coefficient == 1);
    BOOST_TEST(p.neat.excess_coefficient == 1);
    BOOST_TEST(p.neat.weight_coefficient == 1.5);
    BOOST_TEST(p.neat.young_age == 5);
    BOOST_TEST(p.neat.young_boost == 1.1);
    BOOST_TEST(p.neat.old_age == 30);
    BOOST_TEST(p.neat.old_penalty == 1);
    BOOST_TEST(p.neat.stagnation_limit == 50);
    BOOST_TEST(p.neat.stagnation_penalty == 1e-7);
    BOOST_TEST(p.neat.fitness_floor == 1e-4);
    BOOST_TEST(p.neat.survival_rate == 0.25);
    BOOST_TEST(p.neat.crossover_rate == 0.75);
    BOOST_TEST(p.neat.multipoint_rate == 0.75);
    BOOST_TEST(p.neat.interspecies_rate == 1e-4);
    BOOST_TEST(p.neat.mutation_rate == 0.25);
    BOOST_TEST(p.neat.add_node_rate == 0.01);
    BOOST_TEST(p.neat.add_link_rate == 0.07);
    BOOST_TEST(p.neat.remove_link_rate == 0.01);
    BOOST_TEST(p.neat.mutate_weights_rate == 0.75);
    BOOST_TEST(p.neat.weight_severe_rate == 0.25);
    BOOST_TEST(p.neat.weight_replacement == 1);
    BOOST_TEST(p.neat.weight_limit == 8);
    BOOST_TEST(p.neat.recurrent_rate == 0.25);
    BOOST_TEST(p.neat.loop_rate == 0.25);
    BOOST_TEST(p.neat.link_tries == 128);
    BOOST_TEST(p.neat.split_tries == 32);
    BOOST_TEST(p.neat.operator_tries == 64);
    BOOST_TEST(p.neat.mate_tries == 32);
    BOOST_TEST(p.neat.clone_tries == 40);
    BOOST_TEST(p.neat.clone_distance == 1e-5);
    BOOST_TEST(p.novelty.archive_threshold == 0.5);
    BOOST_TEST(p.novelty.archive_floor == 0.05);
    BOOST_TEST(p.novelty.archive_raise == 1.1);
    BOOST_TEST(p.novelty.archive_lower == 0.9);
}

BOOST_AUTO_TEST_CASE(ages_stagnation_records_and_the_mark_go_as_worked_by_hand) {
    Population population = far_apart({5, 5});
    const Parameters parameters = frozen(60);
    struct Expected {
        std::vector<double> scores;
        int age[2], stagnation[2];
        double best_ever[2];
        int marked;
        double record;
    };
    const Expected generations[] = {
        // No species has a record yet, so the first in the list holds it; both improve.
        {{2, 3}, {1, 1}, {0, 0}, {2, 3}, 0, 3},
        // The mark follows the record of before; who loses it is young again.
        {{2.5, 1}, {0, 2}, {0, 1}, {2.5, 3}, 1, 3},
        // A score equal to the best before is no improvement. The new record of the other is not yet seen.
        {{4, 3}, {1, 3}, {0, 2}, {4, 3}, 1, 4},
        {{1, 1}, {2, 0}, {1, 0}, {4, 3}, 0, 4},
        {{1, 1}, {3, 1}, {2, 1}, {4, 3}, 0, 4},
        // A score of zero counts as the floor, which is no rise here.
        {{0, 0}, {4, 2}, {3, 2}, {4, 3}, 0, 4},
    };
    for (const Expected &expected : generations) {
        population = after(population, expected.scores, parameters);
        BOOST_TEST_CONTEXT("generation " << population.generation) {
            for (const int id : {0, 1}) {
                BOOST_TEST(find(population, id).age == expected.age[id]);
                BOOST_TEST(find(population, id).stagnation == expected.stagnation[id]);
                BOOST_TEST(find(population, id).best_ever == expected.best_ever[id]);
                BOOST_TEST(find(population, id).best == (id == expected.marked));
            }
            BOOST_TEST(population.best_ever == expected.record);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_species_that_never_scored_has_the_floor_as_its_best) {
    const Population next = after(far_apart({2, 2}), {0, 1}, frozen(40));
    BOOST_TEST(next.species.size() == 1u); // 1e-4 of 1 is a quota of no child
    const Population even = after(far_apart({2, 2}), {0, 0}, frozen(40));
    for (const Species &species : even.species) BOOST_TEST(species.best_ever == 1e-4);
    BOOST_TEST(even.best_ever == 0);
}

BOOST_AUTO_TEST_CASE(a_species_that_loses_the_mark_counts_as_young_at_once) {
    // The first has stagnated for long, but loses the mark to the second now: age and stagnation are reset before
    // the offspring is shared out, 1.1 to 1.
    Population population = far_apart({1, 1});
    population.best_ever = 5;
    population.species[0].best_ever = 4, population.species[0].best = true;
    population.species[1].best_ever = 5;
    for (Species &species : population.species) species.age = species.stagnation = 70;
    const Population next = after(population, {1, 1}, frozen(210));
    BOOST_TEST(find(next, 0).members.size() == 110u);
    BOOST_TEST(find(next, 1).members.size() == 100u);
}

BOOST_AUTO_TEST_CASE(the_mark_alone_keeps_a_stagnating_species_alive) {
    Population population = far_apart({3, 3});
    population.best_ever = 5;
    for (Species &species : population.species) species.age = species.stagnation = 70, species.best_ever = 5;
    const Population next = after(population, {2, 4}, frozen(30));
    BOOST_TEST(sizes(next) == (std::vector<int>{30}), per_element());
    BOOST_TEST(next.species[0].id == 0); // the first at the record
}

BOOST_AUTO_TEST_CASE(children_try_species_in_the_order_of_their_records) {
    // All weights lie within the threshold of each other, so that the first species in the order takes all.
    Population population = populations::of({{0}, {1}, {2}});
    const double records[] = {1, 3, 2};
    for (int i = 0; i < 3; ++i) population.species[i].best_ever = records[i];
    population.best_ever = 3;
    Parameters parameters = frozen(12);
    parameters.neat.weight_coefficient = 1;
    const Population next = after(population, {1, 1, 1}, parameters);
    BOOST_REQUIRE(next.species.size() == 1u);
    BOOST_TEST(next.species[0].id == 1);
    BOOST_TEST(next.species[0].members.size() == 12u);
    BOOST_TEST(next.genomes[0].mother == 1); // and its own champion is born first
}

BOOST_AUTO_TEST_CASE(rounding_gives_exactly_three_hundred) {
    // 300 / 7 = 42.86, rounded seven times: one too many, so the last born of the last species is not born.
    const auto even = [](int count) {
        return sizes(
            after(far_apart(std::vector<int>(count, 2)), std::vector<double>(count, 1), frozen(300)));
    };
    BOOST_TEST(even(7) == (std::vector<int>{43, 43, 43, 43, 43, 43, 42}), per_element());
    // 300 / 13 = 23.08: one too few, so the first takes a copy.
    std::vector<int> thirteen(13, 23);
    thirteen[0] = 24;
    BOOST_TEST(even(13) == thirteen, per_element());

    // Halves are rounded up: of 2.5 each for four, the last has what is left.
    const Population halves = after(far_apart({2, 2, 2, 2}), {1, 1, 1, 1}, frozen(10));
    BOOST_TEST(sizes(halves) == (std::vector<int>{3, 3, 3, 1}), per_element());

    // Whatever the scores.
    Stream stream = specimens::stream(12);
    for (int n = 0; n < 40; ++n) {
        const int count = 1 + static_cast<int>(stream.below(14));
        std::vector<double> scores;
        for (int i = 0; i < count; ++i) scores.push_back(stream.chance(0.1) ? 0 : 10 * stream.uniform());
        const Population next = after(far_apart(std::vector<int>(count, 3)), scores, frozen(300));
        BOOST_TEST(next.genomes.size() == 300u);
        const std::vector<int> each = sizes(next);
        BOOST_TEST(std::accumulate(each.begin(), each.end(), 0) == 300);
    }
}

BOOST_AUTO_TEST_CASE(the_threshold_has_no_ceiling) {
    Population population = far_apart(std::vector<int>(11, 1));
    population.threshold = 1000;
    const Population next = after(population, std::vector<double>(11, 1), frozen(11));
    BOOST_TEST(next.threshold == 1000 + 0.2);
}

BOOST_AUTO_TEST_CASE(innovations_are_kept_for_the_whole_run) {
    // The same link is split in two generations far apart: one and the same node.
    Parameters splitting;
    splitting.neat.population = 4;
    splitting.neat.add_node_rate = 1;
    splitting.neat.add_link_rate = splitting.neat.remove_link_rate = splitting.neat.mutate_weights_rate = 0;
    Population population = populations::of({{1, 2}});
    const std::vector<double> scores{1, 1};
    const Population early = reproduce(population, scores, Adjustment::sharing, false, splitting.neat, 1);
    const int node = early.innovations.splits(0, 2)[0];
    Population later = early;
    for (int generation = 0; generation < 5; ++generation)
        later = reproduce(later, std::vector<double>(4, 1), Adjustment::sharing, false, frozen(4).neat, 1);
    BOOST_TEST(later.innovations.splits(0, 2)[0] == node);
    Innovations record = later.innovations;
    Genome plain = population.genomes[0];
    Stream stream = specimens::stream(1);
    BOOST_REQUIRE(add_node(splitting.neat, false, record, stream, plain));
    BOOST_TEST(plain.nodes.back().id == node);
}

BOOST_AUTO_TEST_CASE(no_two_children_of_a_generation_are_equal) {
    const Parameters parameters;
    Population population = initial_population({4, 2, false}, parameters.neat, 3);
    for (int generation = 0; generation < 3; ++generation) {
        std::vector<double> scores;
        for (const Genome &genome : population.genomes)
            scores.push_back(1 + static_cast<double>(genome.id % 7));
        population = reproduce(population, scores, Adjustment::sharing, false, parameters.neat, 3);
        std::vector<Genome> before;
        for (const Genome &genome : population.genomes) {
            if (genome.origin == Origin::filler) continue;
            BOOST_TEST_REQUIRE((genome.origin != Origin::clone)); // tries 2 to 40 have changed its weights
            BOOST_TEST_REQUIRE(!is_clone(genome, before, parameters.neat));
            before.push_back(genome);
        }
    }
}

BOOST_AUTO_TEST_CASE(feed_forward_populations_stay_without_cycles) {
    NeatParameters parameters = specimens::structural();
    parameters.population = 80;
    parameters.interspecies_rate = 0.2; // fathers from anywhere bring all their links
    Population population = initial_population({4, 3, false}, parameters, 8);
    for (int generation = 0; generation < 60; ++generation) {
        std::vector<double> scores;
        for (const Genome &genome : population.genomes) {
            BOOST_REQUIRE(!has_cycle(genome));
            scores.push_back(static_cast<double>(genome.links.size())); // the larger the better
        }
        population = reproduce(population, scores, Adjustment::sharing, false, parameters, 8);
    }
    BOOST_TEST(population.genomes[0].hidden() > 5);

    Genome looped = specimens::bare(2, 1);
    looped.nodes.push_back({3, NodeKind::hidden, 0.5});
    looped.links = {{0, 0, 3, 1, false}, {1, 3, 2, 1, false}};
    BOOST_TEST(!has_cycle(looped));
    looped.links.push_back({2, 2, 3, 1, true});
    BOOST_TEST(has_cycle(looped));
}

BOOST_AUTO_TEST_CASE(a_link_to_split_is_drawn_so_often_and_no_more) {
    // One of four links may be split; with two draws the operator fails in (3/4)² of all cases.
    Parameters parameters;
    parameters.neat.split_tries = 2;
    Genome genome = specimens::bare(2, 4);
    Innovations innovations(6);
    for (const auto &[from, to] : {std::pair{1, 2}, {1, 3}, {1, 4}, {0, 5}})
        genome.links.push_back({innovations.link(from, to), from, to, 1, false});
    int failures = 0;
    for (int n = 0; n < 4000; ++n) {
        Genome copy = genome;
        Stream stream = specimens::stream(n);
        failures += !add_node(parameters.neat, false, innovations, stream, copy);
    }
    BOOST_TEST(std::abs(failures - 2250) < 160);
}

BOOST_AUTO_TEST_CASE(the_archive_and_its_threshold_go_as_worked_by_hand) {
    Parameters parameters;
    parameters.novelty.novelty_neighbours = 1;
    parameters.novelty.archive_threshold = 1;
    parameters.novelty.archive_run = 2;
    parameters.novelty.archive_raise = 1.5;
    parameters.novelty.archive_patience = 2;
    parameters.novelty.archive_lower = 0.5;
    parameters.novelty.archive_floor = 0.625;
    constexpr double invalid = -1;
    struct Expected {
        std::vector<double> places; // on a line
        std::vector<double> novelties;
        std::vector<std::int64_t> archive; // ids of those who enter
        double threshold;
    };
    const std::vector<Expected> generations{
        // Ids 0 to 2: the third in a row raises.
        {{0, 10, 20}, {10, 10, 10}, {0, 1, 2}, 1.5},
        // 3 is refused and ends the row; 4 is passed over; 5, 6 and 7 are three in a row.
        {{11.4, invalid, 40, 44, 60}, {1.4, 0, 4, 4, 16}, {5, 6, 7}, 2.25},
        // A neighbour in the archive at the same place: no novelty at all.
        {{0.5, 10}, {0.5, 0}, {}, 2.25},
        // The second generation without an addition lowers.
        {{invalid}, {0}, {}, 1.125},
        // One enters; this begins a row, and a new count of generations.
        {{46}, {2}, {11}, 1.125},
        {{invalid, invalid}, {0, 0}, {}, 1.125},
        // Half would lie below the floor.
        {{invalid}, {0}, {}, 0.625},
        // The invalid have not ended the row: 15 is its second, 16 its third.
        {{100, 200}, {40, 100}, {15, 16}, 0.9375},
        // Equal to the threshold is not above it; it ends the row and counts as no addition.
        {{200.9375}, {0.9375}, {}, 0.9375},
        {{300, 400, 500}, {100, 100, 100}, {18, 19, 20}, 0.9375 * 1.5},
    };

    NoveltySearch search(parameters);
    Population population;
    std::size_t archived = 0;
    for (const Expected &expected : generations) {
        std::vector<Evaluation> evaluations;
        population.genomes.assign(expected.places.size(), Genome());
        for (std::size_t slot = 0; slot < expected.places.size(); ++slot) {
            population.genomes[slot].id = population.next_genome++;
            const bool is_valid = expected.places[slot] != invalid;
            evaluations.push_back({0, {expected.places[slot]}, is_valid ? 1.0 : 0.0});
        }
        const std::vector<double> scores = search.score(population, evaluations);
        BOOST_TEST_CONTEXT("generation " << population.generation) {
            for (std::size_t slot = 0; slot < scores.size(); ++slot)
                BOOST_TEST(std::abs(scores[slot] - expected.novelties[slot]) < 1e-12);
            std::vector<std::int64_t> entered;
            for (; archived < search.archive().size(); ++archived)
                entered.push_back(search.archive()[archived].genome);
            BOOST_TEST(entered == expected.archive, per_element());
            BOOST_TEST(search.archive_threshold() == expected.threshold);
        }
        ++population.generation;
    }
}

BOOST_AUTO_TEST_CASE(fewer_than_k_neighbours_are_all_of_them) {
    // Ids 0, 1: one neighbour each; then two in the archive; k is 15.
    NoveltySearch search{Parameters()};
    Population population;
    population.genomes.resize(2);
    const auto score = [&](std::vector<Evaluation> evaluations) {
        return search.score(population, evaluations);
    };
    BOOST_TEST(score({{0, {0}, 1}, {0, {4}, 1}}) == (std::vector<double>{4, 4}), per_element());
    // From 1: 1 and 3 in the archive, 9 to the other. From 10: 10, 6, 9. The invalid one is no neighbour.
    BOOST_TEST(score({{0, {1}, 1}, {0, {10}, 1}}) == (std::vector<double>{13.0 / 3, 25.0 / 3}),
               per_element());
    // All four are archived: from 0 these are 0, 1, 4 and 10 away.
    BOOST_TEST(score({{0, {0}, 0.1}, {0, {3}, 0}})[0] == 15.0 / 4 * 0.1);
}
