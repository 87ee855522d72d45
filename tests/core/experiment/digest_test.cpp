// SPDX-License-Identifier: MIT
#include "experiment/digest.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <string>
#include <type_traits>
#include <utility>

using namespace planula;

namespace {

struct FakeSearch final : Search {
    std::vector<ArchiveEntry> entries;
    double threshold = 0.5;

    std::vector<double> score(const Population &, std::span<const Evaluation>) override { return {}; }
    Population next(const Population &population, std::span<const double>, const NetworkShape &,
                    std::uint64_t) const override {
        return population;
    }
    std::span<const ArchiveEntry> archive() const override { return entries; }
    double archive_threshold() const override { return threshold; }
    void save(const Population &, StateWriter &) const override {}
    void load(const Population &, std::span<const ArchiveEntry>, StateReader &) override {}
};

/// Generation 7 of two individuals, with something in every list.
struct Made {
    int number = 7, best = 1;
    Population population;
    std::vector<Life> lives{2};
    std::vector<Evaluation> evaluations{{1, {1, 2}, 1}, {2, {3, 4}, 1}};
    std::vector<double> scores{1, 2};
    FakeSearch search;
    Mothers mothers;
    Known known{};

    Made() {
        population.genomes.resize(2);
        for (Genome &genome : population.genomes) genome.nodes.resize(2), genome.links.resize(2);
        population.species.resize(2);
        for (Species &species : population.species) species.members = {0};
        for (Life &life : lives) life.path.resize(2);
        search.entries = {{6, 1, {1, 2}, 3, 4}, {7, 2, {1, 2}, 3, 4}, {7, 3, {1, 2}, 3, 4}};
    }
    std::string digest() const {
        Hash hash;
        planula::digest(hash, {number, population, lives, evaluations, scores, search, mothers, best, known});
        return hash.hex();
    }
};

// ---- The changes of a field, each undone afterwards -------------------------------------------------------

template <class T> void expect_seen(const Made &made, T &field, T changed) {
    const std::string before = made.digest();
    std::swap(field, changed);
    BOOST_TEST(made.digest() != before);
    std::swap(field, changed);
    BOOST_TEST(made.digest() == before);
}

template <class Whole>
requires std::is_integral_v<Whole> || std::is_enum_v<Whole>
void change(const Made &made, Whole &field) {
    expect_seen(made, field, static_cast<Whole>(static_cast<int>(field) ^ 1));
}

template <class Real>
requires std::is_floating_point_v<Real>
void change(const Made &made, Real &field) {
    expect_seen(made, field, std::nextafter(field, Real{100}));
    const Real value = std::exchange(field, Real{0});
    expect_seen(made, field, -Real{0});
    field = value;
}

void change(const Made &made, Vec2d &field) {
    auto &[x, y] = field;
    change(made, x), change(made, y);
}

void change(const Made &made, ShapeDistribution &field) {
    for (float &share : field) change(made, share);
}

/// The records of a list are changed by themselves.
template <class T> void change(const Made &made, std::vector<T> &field) {
    std::vector<T> longer = field, shorter = field;
    longer.emplace_back(), shorter.pop_back();
    expect_seen(made, field, longer);
    expect_seen(made, field, shorter);
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, Vec2d>)
        for (T &each : field) change(made, each);
}

template <class... Fields> void change_each(const Made &made, Fields &...fields) {
    (change(made, fields), ...);
}

} // namespace

// The fields of lives come from a list. Those of all other records are named here too: who adds a field must add it to
// its test.

BOOST_AUTO_TEST_CASE(every_field_of_a_life_is_in_the_digest) {
    Made made;
    for (Life &life : made.lives) each_field(life, [&](auto &field) { change(made, field); });
    change(made, made.lives);
}

BOOST_AUTO_TEST_CASE(every_field_of_a_genome_is_in_the_digest) {
    Made made;
    for (Genome &genome : made.population.genomes) {
        auto &[id, mother, father, origin, inputs, outputs, nodes, links] = genome;
        change_each(made, id, mother, father, origin, inputs, outputs, nodes, links);
        for (NodeGene &node : nodes) {
            auto &[node_id, kind, depth] = node;
            change_each(made, node_id, kind, depth);
        }
        for (LinkGene &link : links) {
            auto &[innovation, from, to, weight, recurrent] = link;
            change_each(made, innovation, from, to, weight, recurrent);
        }
    }
}

BOOST_AUTO_TEST_CASE(every_field_of_population_and_species_is_in_the_digest) {
    Made made;
    auto &[generation, genomes, all_species, threshold, best_ever, next_genome, next_species, innovations] =
        made.population;
    change_each(made, generation, genomes, all_species, threshold, best_ever, next_genome, next_species);
    for (Species &species : all_species) {
        auto &[id, representative, age, stagnation, record, best, members] = species;
        change_each(made, id, representative.id, age, stagnation, record, best, members);
    }
    const std::string before = made.digest();
    innovations.link(0, 1);
    const std::string linked = made.digest();
    innovations.new_split(0, 1);
    BOOST_TEST(linked != before);
    BOOST_TEST(made.digest() != linked);
}

BOOST_AUTO_TEST_CASE(every_field_of_an_evaluation_and_of_a_generation_is_in_the_digest) {
    Made made;
    for (Evaluation &evaluation : made.evaluations) {
        auto &[fitness, behaviour, penalty, objectives] = evaluation;
        objectives = {0.5, 6};
        change_each(made, fitness, behaviour, penalty, objectives);
    }
    change_each(made, made.evaluations, made.scores, made.best, made.number, made.search.threshold);
}

BOOST_AUTO_TEST_CASE(the_digest_has_the_new_entries_of_the_archive_and_the_number_of_all) {
    Made made;
    change(made, made.search.entries);
    for (std::size_t i = 1; i < 3; ++i) {
        auto &[generation, genome, behaviour, novelty, fitness, objectives] = made.search.entries[i];
        objectives = {0.5, 6};
        change_each(made, generation, genome, behaviour, novelty, fitness, objectives);
    }
    // An entry of generation 6 is in the digest of that.
    const std::string before = made.digest();
    made.search.entries[0].novelty = 4;
    BOOST_TEST(made.digest() == before);
    made.search.entries.insert(made.search.entries.begin(), ArchiveEntry{5, 0, {1, 2}, 3, 4});
    BOOST_TEST(made.digest() != before);
}

BOOST_AUTO_TEST_CASE(lists_keep_their_borders) {
    // The same numbers in the same order, of one individual and of two.
    Made one, two;
    one.evaluations = {{1, {0.5, 3}, 1}};
    two.evaluations = {{1, {}, 0.5}, {3, {}, 1}};
    BOOST_TEST(one.digest() != two.digest());
}

BOOST_AUTO_TEST_CASE(the_memo_is_not_in_the_digest) {
    Made made;
    const std::string before = made.digest();
    made.known.lives = 2;
    BOOST_TEST(made.digest() == before);
}

BOOST_AUTO_TEST_CASE(the_results_of_mothers_are_not_in_the_digest) {
    Made made;
    const std::string before = made.digest();
    made.mothers.add(made.population, made.lives, made.evaluations);
    BOOST_TEST(made.digest() == before);
}

BOOST_AUTO_TEST_CASE(a_second_digest_into_one_hash_changes_it) {
    const Made made;
    const Generation generation{made.number, made.population, made.lives, made.evaluations, made.scores,
                                made.search, made.mothers,    made.best,  made.known};
    Hash once, twice;
    digest(once, generation);
    digest(twice, generation);
    BOOST_TEST(once.hex() == twice.hex());
    digest(twice, generation);
    BOOST_TEST(once.hex() != twice.hex());
}
