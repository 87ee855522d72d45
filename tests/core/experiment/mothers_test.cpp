// SPDX-License-Identifier: MIT
#include "experiment/mothers.h"

#include "base/error.h"
#include "core/experiment/swimmers.h"
#include "experiment/run.h"

#include <boost/test/unit_test.hpp>

#include <map>
#include <string>
#include <vector>

using namespace planula;

namespace {

Genome child_of(std::int64_t id, std::int64_t mother, Origin origin = Origin::mutation) {
    Genome genome;
    genome.id = id, genome.mother = mother, genome.origin = origin;
    return genome;
}

Population of(const std::vector<Genome> &genomes) {
    Population population;
    population.genomes = genomes;
    return population;
}

/// Genomes 0, 1 and 2 with fitness 1, 2 and 3 and 10, 20 and 30 cells.
Mothers three() {
    std::vector<Life> lives(3);
    for (int i = 0; i < 3; ++i) lives[static_cast<std::size_t>(i)].cells = 10 * (i + 1);
    Mothers mothers;
    mothers.add(of({child_of(0, -1), child_of(1, -1), child_of(2, -1)}), lives,
                std::vector<Evaluation>{{1, {}, 1}, {2, {}, 1}, {3, {}, 1}});
    return mothers;
}

std::string saved(const Mothers &mothers) {
    StateWriter writer;
    mothers.save(writer);
    return writer.bytes();
}

/// Mothers of a run as they should be, and which they were.
struct Seen {
    std::map<std::int64_t, MotherLife> lives; // of all individuals so far
    int known = 0,
        earlier = 0;    // children with a known mother; those whose mother is older than the last generation
    bool keeps = false; // whether the search keeps individuals
};

} // namespace

BOOST_AUTO_TEST_CASE(a_changed_child_has_the_life_of_its_mother_and_a_copy_has_none) {
    const Mothers mothers = three();
    for (const Origin origin : {Origin::mutation, Origin::crossover, Origin::crossover_mutation})
        BOOST_TEST((*mothers.of(child_of(7, 1, origin)) == MotherLife{2, 20}));
    for (const Origin origin : {Origin::initial, Origin::champion, Origin::filler, Origin::clone})
        BOOST_TEST(mothers.of(child_of(7, 1, origin)) == nullptr);
    BOOST_TEST(mothers.of(child_of(7, 4)) == nullptr);
}

BOOST_AUTO_TEST_CASE(an_individual_without_children_that_is_not_kept_is_forgotten) {
    Mothers mothers = three();
    mothers.keep(of({child_of(3, 0), child_of(4, 1, Origin::champion)}), std::vector{child_of(2, -1)});
    BOOST_TEST(mothers.of(child_of(7, 0))->fitness == 1);
    BOOST_TEST(mothers.of(child_of(7, 1)) == nullptr);
    BOOST_TEST(mothers.of(child_of(7, 2))->cells == 30);
}

BOOST_AUTO_TEST_CASE(a_mother_that_was_never_simulated_is_an_internal_error) {
    Mothers mothers = three();
    BOOST_CHECK_THROW(mothers.keep(of({child_of(3, 9)}), {}), InternalError);
}

BOOST_AUTO_TEST_CASE(only_the_mothers_of_the_population_are_loaded) {
    Mothers mothers = three();
    const Population population = of({child_of(3, 0), child_of(4, 1)});
    mothers.keep(population, {});
    const std::string bytes = saved(mothers);
    const auto load = [](const std::string &state, const Population &next) {
        StateReader reader(state);
        Mothers loaded = Mothers::load(next, {}, reader);
        reader.done();
        return loaded;
    };
    BOOST_TEST((saved(load(bytes, population)) == bytes));
    BOOST_CHECK_THROW(load(bytes, of({child_of(3, 0)})), InputError);
    BOOST_CHECK_THROW(load(bytes, of({child_of(3, 0), child_of(4, 2)})), InputError);
    const auto with = [&](double fitness, int cells) {
        StateWriter writer;
        writer.group("mothers").integer(1).integer(0).real(fitness).integer(cells);
        return load(writer.bytes(), of({child_of(3, 0)}));
    };
    BOOST_TEST(with(2.5, 7).of(child_of(3, 0))->cells == 7);
    BOOST_CHECK_THROW(with(-1, 7), InputError);
    BOOST_CHECK_THROW(with(1, -7), InputError);
}

BOOST_AUTO_TEST_CASE(in_every_search_every_changed_child_finds_its_mothers_own_life) {
    for (const std::string_view search : search_names()) {
        Spec spec = swimmers(search, Actuation::oscillator, 12, 100);
        spec.parameters.design.generations = 6;
        Seen seen;
        run(spec, 3, 2, [&](const Generation &g) {
            seen.keeps = !g.search.kept_genomes().empty();
            for (std::size_t slot = 0; slot < g.lives.size(); ++slot) {
                const Genome &child = g.population.genomes[slot];
                const MotherLife *mother = g.mothers.of(child);
                if (mother) BOOST_TEST((*mother == seen.lives.at(child.mother)));
                const bool is_changed = child.origin >= Origin::mutation;
                BOOST_TEST((mother != nullptr) == is_changed);
                seen.known += mother != nullptr;
                // Genomes are numbered in order of birth, twelve to a generation.
                seen.earlier += mother && child.mother < 12 * (g.number - 1);
            }
            for (std::size_t slot = 0; slot < g.lives.size(); ++slot)
                seen.lives[g.population.genomes[slot].id] = {g.evaluations[slot].fitness,
                                                             g.lives[slot].cells};
        });
        BOOST_TEST(seen.known > 5 * 6, search);
        BOOST_TEST((seen.earlier > 0) == seen.keeps, search);
    }
}
