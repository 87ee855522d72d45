// SPDX-License-Identifier: MIT
#include "evolution/novelty_search.h"

#include "base/error.h"
#include "base/random.h"
#include "core/evolution/populations.h"
#include "evolution/reproduce.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace planula;
using boost::test_tools::per_element;

namespace {

Evaluation at(std::vector<double> behaviour, double penalty = 1) {
    return {1, std::move(behaviour), penalty};
}
Evaluation invalid() { return {0, {}, 0}; }

/// A run of generations; genome ids count on.
struct Run {
    explicit Run(Parameters parameters) : search(parameters) {}

    std::vector<double> generation(const std::vector<Evaluation> &evaluations) {
        population.genomes.resize(evaluations.size());
        for (auto &genome : population.genomes) genome.id = next++;
        std::vector<double> scores = search.score(population, evaluations);
        ++population.generation;
        return scores;
    }
    /// `count` individuals on a line, each 10 from the next, beyond all that came before.
    void explore(int count) {
        std::vector<Evaluation> evaluations;
        for (int i = 0; i < count; ++i) evaluations.push_back(at({frontier += 10, 0}));
        generation(evaluations);
    }

    NoveltySearch search;
    Population population;
    std::int64_t next = 0;
    double frontier = 0;
};

Parameters nearest(int k) {
    Parameters parameters;
    parameters.novelty.novelty_neighbours = k;
    return parameters;
}

/// The threshold after these numbers of raises and falls, in the order of the search's own products.
double moved(double threshold, int raises, int falls = 0) {
    for (int i = 0; i < raises; ++i) threshold *= 1.1;
    for (int i = 0; i < falls; ++i) threshold *= 0.9;
    return threshold;
}

} // namespace

BOOST_AUTO_TEST_CASE(novelty_is_the_mean_distance_to_the_k_nearest) {
    // Eq. (7). Distances from (0, 0): 1, 5, 10.
    const std::vector<Evaluation> evaluations{at({0, 0}), at({3, 4}), at({0, 1}), at({6, 8})};
    const double root18 = std::sqrt(18.0), root85 = std::sqrt(85.0);
    const std::vector<double> of_two{3, (root18 + 5) / 2, (1 + root18) / 2, (5 + root85) / 2};
    BOOST_TEST(Run(nearest(2)).generation(evaluations) == of_two, per_element());
    BOOST_TEST(Run(nearest(1)).generation(evaluations)[3] == 5);
    // Fewer than k: the mean over those there are; alone: 0.
    BOOST_TEST(Run(nearest(15)).generation(evaluations)[0] == 16.0 / 3);
    BOOST_TEST(Run(nearest(15)).generation({at({7, 7})})[0] == 0);
}

BOOST_AUTO_TEST_CASE(others_at_the_same_place_are_neighbours_but_oneself_is_not) {
    const auto scores = Run(nearest(1)).generation({at({1, 1}), at({1, 1}), at({1, 3})});
    BOOST_TEST(scores == (std::vector<double>{0, 0, 2}), per_element());
}

BOOST_AUTO_TEST_CASE(the_archive_of_earlier_generations_counts_as_neighbours) {
    Run run(nearest(1));
    run.generation({at({0, 0}), at({10, 0})});
    BOOST_REQUIRE(run.search.archive().size() == 2u);
    BOOST_TEST(run.generation({at({0, 3}), at({100, 0})}) == (std::vector<double>{3, 90}), per_element());
}

BOOST_AUTO_TEST_CASE(novelty_is_taken_before_this_generation_enters_the_archive) {
    // The two are 0.6 apart; were the first archived before the second is judged, it would count twice.
    Run run(nearest(2));
    const auto scores = run.generation({at({0, 0}), at({0.6, 0}), at({5, 0})});
    BOOST_TEST(scores[1] == (0.6 + 4.4) / 2);
    BOOST_TEST(run.search.archive().size() == 3u);
}

BOOST_AUTO_TEST_CASE(archive_entries_state_who_entered_when_and_how_novel) {
    Run run(nearest(1));
    run.generation({at({0, 0}), at({0, 0}), at({0, 2})});
    BOOST_REQUIRE(run.search.archive().size() == 1u);
    run.generation({at({0, 9})});
    const ArchiveEntry &first = run.search.archive()[0], &second = run.search.archive()[1];
    BOOST_TEST(first.generation == 0);
    BOOST_TEST(first.genome == 2);
    BOOST_TEST(first.novelty == 2);
    BOOST_TEST(second.generation == 1);
    BOOST_TEST(second.genome == 3);
    BOOST_TEST(second.behaviour == (std::vector<double>{0, 9}), per_element());
    BOOST_TEST(second.novelty == 7);
}

BOOST_AUTO_TEST_CASE(an_invalid_individual_is_as_if_it_did_not_exist) {
    Run run(nearest(1));
    const auto scores = run.generation({at({0, 0}), {5, {0, 0.5}, 0}, at({0, 4}), invalid()});
    BOOST_TEST(scores == (std::vector<double>{4, 0, 4, 0}), per_element());
    BOOST_TEST(run.search.archive().size() == 2u);
    BOOST_TEST(run.generation({invalid()})[0] == 0);
}

BOOST_AUTO_TEST_CASE(the_penalty_lowers_the_score_but_not_the_entry_to_the_archive) {
    Run run(nearest(1));
    const auto scores = run.generation({at({0, 0}, 0.1), at({0.6, 0}, 0.1)});
    BOOST_TEST(scores[0] == 0.6 * 0.1);
    BOOST_TEST(run.search.archive().size() == 2u);
    BOOST_TEST(run.search.archive()[0].novelty == 0.6);
}

BOOST_AUTO_TEST_CASE(novelty_equal_to_the_threshold_does_not_enter) {
    Run run(nearest(1));
    run.generation({at({0, 0}), at({0.5, 0})});
    BOOST_TEST(run.search.archive().empty());
}

BOOST_AUTO_TEST_CASE(the_threshold_rises_with_every_addition_from_the_ninth_in_a_row_on) {
    Run run(nearest(1));
    BOOST_TEST(run.search.archive_threshold() == 0.5);
    run.explore(8);
    BOOST_TEST(run.search.archive_threshold() == 0.5);
    run.explore(1); // a run goes on across generations
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 1));
    run.explore(3); // and a raise does not end it
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 4));

    // The first that is not added does.
    run.generation({at({10, 0})});
    run.explore(8);
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 4));
    run.explore(1);
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 5));
}

BOOST_AUTO_TEST_CASE(the_threshold_moves_within_the_walk) {
    // Twelve pairs of novelty 0.52: the ninth addition raises the threshold to 0.55, and no more enter.
    std::vector<Evaluation> evaluations;
    for (int i = 0; i < 24; ++i) evaluations.push_back(at({i / 2 * 100.0, i % 2 * 0.52}));
    Run run(nearest(1));
    run.generation(evaluations);
    BOOST_TEST(run.search.archive().size() == 9u);
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 1));
}

BOOST_AUTO_TEST_CASE(the_invalid_neither_add_to_a_run_nor_end_it) {
    std::vector<Evaluation> evaluations;
    for (int i = 0; i < 9; ++i) {
        evaluations.push_back(at({i * 10.0, 0}));
        evaluations.push_back(invalid());
    }
    Run run(nearest(1));
    run.generation(evaluations);
    BOOST_TEST(run.search.archive().size() == 9u);
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 1));
}

BOOST_AUTO_TEST_CASE(the_threshold_falls_after_fifty_generations_without_addition_down_to_its_floor) {
    Parameters parameters = nearest(1);
    parameters.novelty.archive_floor = 0.4;
    Run run(parameters);
    const auto quiet = [&](int generations) {
        for (int i = 0; i < generations; ++i) run.generation({at({0, 0}), at({0, 0})});
    };
    quiet(49);
    BOOST_TEST(run.search.archive_threshold() == 0.5);
    quiet(1);
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 0, 1));
    quiet(49); // the count has started again
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 0, 1));
    run.explore(2); // and starts again with an addition
    quiet(49);
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 0, 1));
    quiet(1);
    BOOST_TEST(run.search.archive_threshold() == moved(0.5, 0, 2));
    quiet(50);
    BOOST_TEST(run.search.archive_threshold() == 0.4);
    for (int i = 0; i < 50; ++i)
        run.generation({invalid(), invalid()}); // no valid individual: no addition either
    BOOST_TEST(run.search.archive_threshold() == 0.4);
}

BOOST_AUTO_TEST_CASE(novelty_agrees_bit_for_bit_with_full_sorting_in_any_order) {
    for (const std::size_t length : {1u, 2u, 5u}) {
        Stream stream(3, 0, 0, Purpose::sampling);
        std::vector<Evaluation> evaluations;
        for (int i = 0; i < 120; ++i) {
            std::vector<double> behaviour;
            for (std::size_t j = 0; j < length; ++j) behaviour.push_back(40 * stream.triangular());
            evaluations.push_back(at(behaviour));
        }
        const auto scores = Run(Parameters()).generation(evaluations);
        for (std::size_t self = 0; self < evaluations.size(); ++self) {
            std::vector<double> distances;
            for (std::size_t other = 0; other < evaluations.size(); ++other) {
                double sum = 0;
                for (std::size_t j = 0; j < length; ++j) {
                    const double d = evaluations[self].behaviour[j] - evaluations[other].behaviour[j];
                    sum += d * d;
                }
                if (other != self) distances.push_back(std::sqrt(sum));
            }
            std::sort(distances.begin(), distances.end());
            double sum = 0;
            for (int i = 0; i < 15; ++i) sum += distances[i];
            BOOST_REQUIRE(scores[self] == sum / 15);
        }

        std::reverse(evaluations.begin(), evaluations.end());
        auto reversed = Run(Parameters()).generation(evaluations);
        std::reverse(reversed.begin(), reversed.end());
        BOOST_REQUIRE((reversed == scores));
    }
}

BOOST_AUTO_TEST_CASE(fitness_is_never_read) {
    Run one(nearest(1)), other(nearest(1));
    const auto scores = one.generation({{1, {0, 0}, 1}, {2, {3, 0}, 1}});
    BOOST_TEST((scores == other.generation({{9, {0, 0}, 1}, {0, {3, 0}, 1}})));
}

BOOST_AUTO_TEST_CASE(the_next_generation_is_that_of_neat_without_sharing) {
    const Population population = populations::far_apart({6, 2});
    const std::vector<double> scores{3, 3, 3, 3, 3, 3, 1, 1};
    const Parameters parameters = populations::frozen(8);
    const Population next = NoveltySearch(parameters).next(population, scores, {2, 1, false}, 4);
    BOOST_TEST(
        (next.genomes == reproduce(population, scores, Adjustment::none, false, parameters.neat, 4).genomes));
    BOOST_TEST(populations::sizes(next) == (std::vector<int>{7, 1}), per_element());
    Parameters aged = parameters;
    aged.novelty.novelty_species = NoveltySpecies::aged;
    aged.neat.young_boost = 1;
    const Population with_ages = NoveltySearch(aged).next(population, scores, {2, 1, false}, 4);
    BOOST_TEST(
        (with_ages.genomes == reproduce(population, scores, Adjustment::age, false, aged.neat, 4).genomes));
}

BOOST_AUTO_TEST_CASE(a_saved_search_resumes_as_if_it_had_not_been_stopped) {
    const auto live = [](Run &run, int first, int last) {
        std::vector<double> scores;
        for (int i = first; i < last; ++i) {
            Stream stream(2, i, 0, Purpose::sampling);
            std::vector<Evaluation> evaluations;
            for (int slot = 0; slot < 20; ++slot) {
                const double x = 20 * stream.triangular(), y = 20 * stream.triangular();
                evaluations.push_back(at({x, y}, stream.below(3) / 2.0));
            }
            for (const double score : run.generation(evaluations)) scores.push_back(score);
        }
        return scores;
    };
    Parameters parameters = nearest(3);
    parameters.novelty.archive_patience = 2;
    parameters.novelty.archive_threshold = 4;
    for (const int stop : {0, 1, 13}) {
        Run through(parameters), before(parameters), after(parameters);
        live(through, 0, stop);
        live(before, 0, stop);
        StateWriter writer;
        before.search.save(before.population, writer);
        StateReader reader(writer.bytes());
        after.search.load(after.population, before.search.archive(), reader);
        reader.done();
        after.population.generation = stop;
        BOOST_TEST(live(through, stop, 40) == live(after, stop, 40), per_element());
        BOOST_TEST(through.search.archive_threshold() == after.search.archive_threshold());
        BOOST_TEST(through.search.archive().size() == after.search.archive().size());
        BOOST_TEST(through.search.archive().size() > 20u);
    }
}

BOOST_AUTO_TEST_CASE(unsound_state_is_refused) {
    Run run(nearest(1));
    run.explore(3);
    StateWriter whole;
    run.search.save(run.population, whole);
    for (std::size_t length = 0; length < whole.bytes().size(); ++length) {
        StateReader reader(std::string_view(whole.bytes()).substr(0, length));
        BOOST_CHECK_THROW(Run(nearest(1)).search.load(run.population, run.search.archive(), reader),
                          InputError);
    }
    const auto refused = [&](const StateWriter &writer, std::span<const ArchiveEntry> archive = {}) {
        StateReader reader(writer.bytes());
        BOOST_CHECK_THROW(Run(nearest(1)).search.load(run.population, archive, reader), InputError);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto head = [](double threshold, int run_of_additions, int length, int entries, int quiet = 0) {
        StateWriter writer;
        writer.group("novelty search")
            .group("archive")
            .real(threshold)
            .integer(run_of_additions)
            .integer(quiet);
        writer.integer(length).integer(entries);
        return writer;
    };
    refused(StateWriter().group("fitness search"));
    refused(head(nan, 0, 0, 0));
    refused(head(-1, 0, 0, 0));
    refused(head(1, -1, 0, 0));
    refused(head(1, std::numeric_limits<int>::max(), 0, 0)); // the next addition would overflow
    refused(head(1, 0, 0, 0, Parameters().novelty.archive_patience));
    refused(head(1, 0, -1, 0));
    refused(head(1, 0, 2, 1000));
    const std::vector<ArchiveEntry> one{{0, 0, {1, 2}, 1, 1}}, bare{{0, 0, {}, 1, 1}};
    refused(head(1, 0, 2, 0), one);
    refused(head(1, 0, 2, 2), one);
    refused(head(1, 0, 3, 1), one);
    refused(head(1, 0, 0, 1), bare);
    const StateWriter sound = head(1, 0, 2, 1);
    StateReader reader(sound.bytes());
    BOOST_CHECK_NO_THROW(Run(nearest(1)).search.load(run.population, one, reader));
}

BOOST_AUTO_TEST_CASE(behaviours_that_cannot_be_compared_are_the_users_error) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(Run(Parameters()).generation({at({})}), InputError);
    BOOST_CHECK_THROW(Run(Parameters()).generation({at({1, 2}), at({1})}), InputError);
    BOOST_CHECK_THROW(Run(Parameters()).generation({at({1, nan})}), InputError);
    Run run{Parameters()};
    run.generation({at({1, 2})});
    BOOST_CHECK_THROW(run.generation({at({1, 2, 3})}), InputError); // another length later in the run
    BOOST_CHECK_NO_THROW(run.generation({{1, {nan}, 0}}));          // an invalid one is not looked at
}
