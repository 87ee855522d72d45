// SPDX-License-Identifier: MIT
#include "evolution/reproduce.h"

#include "base/error.h"
#include "core/evolution/populations.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

using namespace planula;
using boost::test_tools::per_element;
using populations::far_apart;
using populations::frozen;
using populations::sizes;

namespace {

std::vector<double> repeat(const std::vector<std::pair<int, double>> &runs) {
    std::vector<double> result;
    for (const auto &[count, value] : runs) result.insert(result.end(), count, value);
    return result;
}

Population next_of(const Population &population, const std::vector<double> &scores,
                   const NeatParameters &parameters, bool shared = true) {
    const Adjustment adjustment = shared ? Adjustment::sharing : Adjustment::none;
    return reproduce(population, scores, adjustment, false, parameters, 1);
}

bool has(const Population &population, int id) {
    return std::any_of(population.species.begin(), population.species.end(),
                       [&](const Species &species) { return species.id == id; });
}

const Species *find(const Population &population, int id) {
    BOOST_TEST_REQUIRE(has(population, id));
    return &*std::find_if(population.species.begin(), population.species.end(),
                          [&](const Species &species) { return species.id == id; });
}

using Sizes = std::vector<int>;

} // namespace

BOOST_AUTO_TEST_CASE(shared_scores_give_each_species_its_mean_and_unshared_ones_its_sum) {
    const Population population = far_apart({6, 2});
    const auto scores = repeat({{6, 3}, {2, 1}});
    BOOST_TEST(sizes(next_of(population, scores, frozen(8).neat)) == (Sizes{6, 2}), per_element());
    BOOST_TEST(sizes(next_of(population, scores, frozen(8).neat, false)) == (Sizes{7, 1}),
               per_element()); // 7.2, 0.8
}

BOOST_AUTO_TEST_CASE(halves_are_rounded_up_and_the_last_born_are_too_many) {
    const Population next = next_of(far_apart({2, 3}), repeat({{5, 1}}), frozen(5).neat); // 2.5 each
    BOOST_TEST(sizes(next) == (Sizes{3, 2}), per_element());
    BOOST_TEST(next.genomes.size() == 5u);
}

BOOST_AUTO_TEST_CASE(slots_left_by_rounding_are_filled) {
    const Population next = next_of(far_apart({4, 3, 3}), repeat({{10, 1}}), frozen(10).neat); // 3.33 each
    BOOST_TEST(sizes(next) == (Sizes{4, 3, 3}), per_element());
    BOOST_TEST((next.genomes[3].origin == Origin::filler));
    BOOST_TEST(next.genomes[3].mother == next.genomes[0].id);
}

BOOST_AUTO_TEST_CASE(species_are_ranked_by_their_best_before_this_generation) {
    Population population = far_apart({1, 1, 1, 1});
    population.best_ever = 5;
    const double best[] = {2, 5, 2, 3};
    for (int i = 0; i < 4; ++i) population.species[i].best_ever = best[i];
    const Population next = next_of(population, {9, 1, 8, 7}, frozen(40).neat);
    Sizes ids;
    for (const auto &species : next.species) ids.push_back(species.id);
    BOOST_TEST(ids == (Sizes{1, 3, 0, 2}), per_element()); // equals keep their order
    BOOST_TEST(find(next, 0)->best_ever == 9);
    BOOST_TEST(find(next, 1)->best_ever == 5);
    BOOST_TEST(next.best_ever == 9);
}

BOOST_AUTO_TEST_CASE(the_champion_is_copied_unchanged_and_first) {
    const Population population = populations::of({{1, 2, 3, 4}});
    NeatParameters parameters;
    parameters.population = 40;
    const Population next = next_of(population, {1, 5, 7, 7}, parameters); // the first of equals
    const Genome &champion = next.genomes[0];
    BOOST_TEST((champion.origin == Origin::champion));
    BOOST_TEST(champion.mother == population.genomes[2].id);
    BOOST_TEST(champion.father == -1);
    BOOST_TEST(champion.id == 4);
    BOOST_TEST((champion.links == population.genomes[2].links));
    const auto champions = std::count_if(next.genomes.begin(), next.genomes.end(),
                                         [](const Genome &g) { return g.origin == Origin::champion; });
    BOOST_TEST(champions == 1);
}

BOOST_AUTO_TEST_CASE(the_first_species_at_the_record_holds_the_mark_by_what_was_known_before) {
    Population population = far_apart({1, 1, 1});
    population.best_ever = 4;
    population.species[0].best_ever = 3;
    population.species[1].best_ever = 4;
    population.species[2].best_ever = 4;
    const Population next =
        next_of(population, {100, 1, 1}, frozen(300).neat); // the record falls, the mark stays
    BOOST_TEST(!find(next, 0)->best);
    BOOST_TEST(find(next, 1)->best);
    BOOST_TEST(!find(next, 2)->best);

    // One generation later the mark has moved, and its old holder is young again.
    Population later = next;
    for (auto &species : later.species) species.age = species.stagnation = 20;
    const Population last = next_of(later, std::vector<double>(later.genomes.size(), 1), frozen(300).neat);
    BOOST_TEST(find(last, 0)->best);
    BOOST_TEST(find(last, 0)->age == 21);
    BOOST_TEST(!find(last, 1)->best);
    BOOST_TEST(find(last, 1)->age == 0);
    BOOST_TEST(find(last, 1)->stagnation == 0);
    BOOST_TEST(find(last, 2)->age == 21);
    BOOST_TEST(find(last, 2)->stagnation == 21);
}

BOOST_AUTO_TEST_CASE(no_species_is_marked_if_the_species_of_the_record_is_gone) {
    Population population = far_apart({1, 1});
    population.best_ever = 10;
    population.species[0].best_ever = 4;
    population.species[0].best = true;
    population.species[0].age = 8;
    const Population next = next_of(population, {1, 1}, frozen(10).neat);
    for (const auto &species : next.species) BOOST_TEST(!species.best);
    BOOST_TEST(find(next, 0)->age == 0); // it has lost the mark
    BOOST_TEST(find(next, 1)->age == 1);
}

BOOST_AUTO_TEST_CASE(in_generation_zero_the_first_species_is_marked_best) {
    const Population next = next_of(far_apart({1, 1}), {1, 2}, frozen(10).neat);
    BOOST_TEST(find(next, 0)->best);
    BOOST_TEST(!find(next, 1)->best);
    BOOST_TEST(next.best_ever == 2);
}

BOOST_AUTO_TEST_CASE(the_factors_of_age_go_without_division_by_size) {
    // Six members of score 1 against two: the share is by the sum, and a young species has its boost.
    Population population = populations::far_apart({6, 2});
    NeatParameters parameters = frozen(40).neat;
    parameters.young_boost = 3;
    population.species[0].age = parameters.young_age;
    const Population next =
        reproduce(population, std::vector<double>(8, 1), Adjustment::age, false, parameters, 1);
    BOOST_TEST(sizes(next) == (Sizes{20, 20}), per_element());
}

BOOST_AUTO_TEST_CASE(young_species_are_boosted_and_old_ones_are_not_while_shared) {
    Population population = far_apart({1, 1, 1});
    population.species[0].age = 3;  // 4 when it counts: young
    population.species[1].age = 4;  // 5: not young
    population.species[2].age = 30; // 31: old
    NeatParameters parameters = frozen(310).neat;
    BOOST_TEST(sizes(next_of(population, {1, 1, 1}, parameters)) == (Sizes{110, 100, 100}), per_element());
    parameters.old_penalty = 0.1;
    BOOST_TEST(sizes(next_of(population, {1, 1, 1}, parameters)) == (Sizes{155, 141, 14}), per_element());
    population.species[2].age = 29;
    parameters.population = 31;
    BOOST_TEST(sizes(next_of(population, {1, 1, 1}, parameters)) == (Sizes{11, 10, 10}), per_element());
    parameters.population = 30;
    BOOST_TEST(sizes(next_of(population, {1, 1, 1}, parameters, false)) == (Sizes{10, 10, 10}),
               per_element());
}

BOOST_AUTO_TEST_CASE(stagnating_species_have_no_offspring_unless_best_or_rising_or_unshared) {
    Population population = far_apart({2, 2, 2, 2});
    population.best_ever = 9;
    const double best[] = {9, 5, 5, 5};
    const int stagnation[] = {80, 50, 49, 50};
    for (int i = 0; i < 4; ++i) {
        population.species[i].age = 10;
        population.species[i].best_ever = best[i];
        population.species[i].stagnation = stagnation[i];
    }
    const auto scores = repeat({{2, 5}, {2, 5}, {2, 5}, {1, 4}, {1, 6}}); // the last rises from 5 to 6
    const Population next = next_of(population, scores, frozen(30).neat);
    BOOST_TEST(find(next, 0)->members.size() == 10u); // marked as best
    BOOST_TEST(!has(next, 1));                        // 51 > 50; equalling the best is no rise
    BOOST_TEST(find(next, 2)->members.size() == 10u); // 50
    BOOST_TEST(find(next, 3)->members.size() == 10u);
    BOOST_TEST(find(next, 3)->stagnation == 0);
    BOOST_TEST(find(next, 3)->best_ever == 6);
    BOOST_TEST(find(next, 2)->stagnation == 50);

    BOOST_TEST(sizes(next_of(population, scores, frozen(40).neat, false)) == (Sizes{10, 10, 10, 10}),
               per_element());
}

BOOST_AUTO_TEST_CASE(scores_of_zero_count_as_the_floor_in_both_searches) {
    const Population population = far_apart({3, 1});
    for (const bool shared : {true, false}) {
        const Population next = next_of(population, {0, 0, 0, 0}, frozen(40).neat, shared);
        BOOST_TEST(sizes(next) == (shared ? Sizes{20, 20} : Sizes{30, 10}), per_element());
        BOOST_TEST(next.best_ever == 0); // the population's record is the bare score
        const Population weighed = next_of(population, {0, 0, 0, 3e-4}, frozen(40).neat, shared);
        BOOST_TEST(sizes(weighed) == (shared ? Sizes{10, 30} : Sizes{20, 20}), per_element());
    }
}

BOOST_AUTO_TEST_CASE(the_threshold_keeps_the_number_of_species_in_its_range) {
    const auto threshold_after = [](int species, double threshold) {
        Population population = far_apart(Sizes(species, 1));
        population.threshold = threshold;
        NeatParameters parameters = frozen(species).neat;
        return next_of(population, std::vector<double>(species, 1), parameters).threshold;
    };
    BOOST_TEST(threshold_after(4, 5) == 5 - 0.2);
    BOOST_TEST(threshold_after(5, 5) == 5);
    BOOST_TEST(threshold_after(10, 5) == 5);
    BOOST_TEST(threshold_after(11, 5) == 5 + 0.2);
    BOOST_TEST(threshold_after(4, 0.3) == 0.2);
}

BOOST_AUTO_TEST_CASE(the_threshold_counts_species_before_extinction_and_places_this_births) {
    // Five species of which four stagnate: the count is still five.
    Population population = far_apart({1, 1, 1, 1, 1});
    population.best_ever = 9;
    population.species[0].best_ever = 9;
    for (int i = 1; i < 5; ++i) {
        population.species[i].best_ever = 5;
        population.species[i].stagnation = 60;
    }
    const Population next = next_of(population, {1, 1, 1, 1, 1}, frozen(5).neat);
    BOOST_TEST(sizes(next) == (Sizes{5}), per_element());
    BOOST_TEST(next.threshold == 5);

    // A child at 4.9 from its species: within the threshold of before, but not within the one that has moved.
    NeatParameters parameters = frozen(1).neat;
    parameters.weight_coefficient = 1;
    Population pair = populations::of({{0, 4.9}});
    BOOST_TEST(next_of(pair, {1, 2}, parameters).species[0].id == 1);
    pair.threshold = 5.2;
    BOOST_TEST(next_of(pair, {1, 2}, parameters).species[0].id == 0);
}

BOOST_AUTO_TEST_CASE(a_species_without_offspring_still_receives_children) {
    // The champion of the first species lives near the second, which stagnates; the first is left empty.
    Population population = populations::of({{0, 4}, {4, 4}});
    population.best_ever = 9;
    population.species[0].best_ever = 9;
    population.species[1].best_ever = 5;
    population.species[1].stagnation = 60;
    NeatParameters parameters = frozen(6).neat;
    parameters.survival_rate = 0;
    population.genomes[0].links[0].weight = 4; // the representative is still the one at 0
    const Population next = next_of(population, {2, 1, 1, 1}, parameters);
    BOOST_REQUIRE(next.species.size() == 1u);
    BOOST_TEST(next.species[0].id == 1);
    BOOST_TEST(next.species[0].age == 1);
    BOOST_TEST(next.species[0].stagnation == 61);
    BOOST_TEST(next.species[0].members.size() == 6u);
    BOOST_TEST(next.genomes[0].mother == 0);
}

BOOST_AUTO_TEST_CASE(scores_that_are_not_numbers_or_too_few_are_an_internal_error) {
    const Population population = far_apart({2});
    for (const std::vector<double> &scores : {std::vector<double>{1},
                                              {1, -1},
                                              {1, std::numeric_limits<double>::quiet_NaN()},
                                              {1, std::numeric_limits<double>::infinity()}})
        BOOST_CHECK_THROW(next_of(population, scores, frozen(2).neat), InternalError);
}

BOOST_AUTO_TEST_CASE(every_generation_of_a_long_run_is_sound_and_repeats_bit_for_bit) {
    NeatParameters parameters = specimens::structural();
    parameters.population = 60;
    for (const bool recurrent : {false, true})
        for (const Adjustment adjustment : {Adjustment::none, Adjustment::age, Adjustment::sharing}) {
            Population population = initial_population({4, 3, recurrent}, parameters, 5);
            std::int64_t born = 60;
            for (int generation = 0; generation < 40; ++generation) {
                std::vector<double> scores;
                for (const auto &genome : population.genomes) // a third scores nothing
                    scores.push_back(genome.id % 3 ? static_cast<double>(genome.id * 7919 % 101) : 0);
                const Population next = reproduce(population, scores, adjustment, recurrent, parameters, 5);
                BOOST_TEST_REQUIRE(
                    (reproduce(population, scores, adjustment, recurrent, parameters, 5).genomes ==
                     next.genomes));
                BOOST_TEST_REQUIRE(next.generation == generation + 1);
                BOOST_TEST_REQUIRE(next.genomes.size() == 60u);

                // Ids are new and unique; parents are of an earlier generation, or for fillers of this one.
                std::set<std::int64_t> ids, parents;
                for (const auto &genome : population.genomes) parents.insert(genome.id);
                for (const auto &genome : next.genomes) {
                    ids.insert(genome.id);
                    check_genome(genome);
                    BOOST_TEST_REQUIRE(!has_dead_ends(genome));
                    BOOST_TEST_REQUIRE((recurrent || specimens::climbs(genome)));
                    BOOST_TEST_REQUIRE((genome.origin == Origin::filler || parents.count(genome.mother)));
                    BOOST_TEST_REQUIRE((genome.father == -1 || parents.count(genome.father)));
                }
                BOOST_TEST_REQUIRE(ids.size() == 60u);
                BOOST_TEST_REQUIRE(*ids.begin() == born);
                born += 60;

                // Slots are species in order, each represented by its first member.
                int slot = 0;
                for (const auto &species : next.species) {
                    BOOST_TEST_REQUIRE((species.representative == next.genomes[species.members.front()]));
                    for (const int member : species.members) BOOST_TEST_REQUIRE(member == slot++);
                }
                BOOST_TEST_REQUIRE(slot == 60);
                population = next;
            }
            BOOST_TEST(population.innovations.links() > 30);
        }
}

BOOST_AUTO_TEST_CASE(another_seed_or_generation_draws_other_children) {
    Population population = populations::of({{1, 2, 3, 4}});
    NeatParameters parameters;
    parameters.population = 20;
    const std::vector<double> scores{4, 3, 2, 1};
    const auto children = [&](std::uint64_t seed) {
        return reproduce(population, scores, Adjustment::sharing, false, parameters, seed).genomes;
    };
    const auto first = children(1);
    BOOST_TEST((first != children(2)));
    population.generation = 8;
    BOOST_TEST((first != children(1)));
}
