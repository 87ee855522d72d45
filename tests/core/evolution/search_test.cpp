// SPDX-License-Identifier: MIT
// What every search must do: the same tests for all of them.
#include "evolution/search.h"

#include "base/error.h"
#include "core/evolution/toy_run.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>

using namespace planula;

namespace {

Parameters of(int population) {
    Parameters parameters;
    parameters.neat.population = population;
    parameters.novelty.archive_patience = 3;
    return parameters;
}

std::string saved(const ToyRun &run) {
    StateWriter writer;
    run.search->save(run.population, writer);
    return writer.bytes();
}

std::vector<ArchiveEntry> archive_of(const Search &search) {
    return {search.archive().begin(), search.archive().end()};
}

/// A search with an archive reads behaviour; one without does not.
bool reads_behaviour(std::string_view name) { return make_search(name, Parameters())->keeps_archive(); }

void check_generation(const ToyRun &run) {
    const Population &p = run.population;
    BOOST_TEST_REQUIRE(static_cast<int>(p.genomes.size()) == run.parameters.neat.population);
    std::vector<int> slots;
    for (const Species &species : p.species)
        slots.insert(slots.end(), species.members.begin(), species.members.end());
    std::vector<int> all(p.genomes.size());
    std::iota(all.begin(), all.end(), 0);
    BOOST_TEST_REQUIRE(slots == all, boost::test_tools::per_element());
    for (const Genome &genome : p.genomes) BOOST_REQUIRE_NO_THROW(check_genome(genome));
    for (const double score : run.scores) BOOST_TEST_REQUIRE((score >= 0 && std::isfinite(score)));
}

} // namespace

BOOST_AUTO_TEST_CASE(every_name_makes_its_search) {
    std::set<std::string_view> names;
    for (const SearchRow &row : search_rows()) {
        BOOST_TEST(names.insert(row.name).second);
        BOOST_TEST(!row.score.empty());
        BOOST_TEST(make_search(row.name, Parameters())->archive().empty());
    }
    BOOST_TEST(search_scores().starts_with("neat: fitness; novelty: "));
    BOOST_TEST(!reads_behaviour("neat"));
    for (const auto name : {"novelty", "nsga2", "nslc", "map-elites"}) BOOST_TEST(reads_behaviour(name));
    BOOST_TEST(make_search("novelty", Parameters())->archive_threshold() == 0.5);
    BOOST_TEST(make_search("map-elites", Parameters())->archive_threshold() == 0);
}

BOOST_AUTO_TEST_CASE(an_error_about_an_unknown_name_suggests_the_nearest_or_lists_all) {
    const auto message_for = [](std::string_view name) -> std::string {
        try {
            make_search(name, Parameters());
        } catch (const InputError &error) {
            return error.what();
        }
        return "";
    };
    BOOST_TEST(message_for("novelti") == "no search is called 'novelti'; did you mean 'novelty'?");
    const std::string message = message_for("simulated annealing");
    BOOST_TEST(
        message.starts_with("no search is called 'simulated annealing'; there are 'neat', 'novelty', "));
    for (const auto name : search_names()) BOOST_TEST(message.find(name) != message.npos);
}

BOOST_AUTO_TEST_CASE(objectives_for_a_search_that_reads_none_are_refused) {
    const Aims aims{{{"work"}}, {}};
    for (const auto name : {"neat", "novelty", "map-elites"}) {
        std::string message;
        try {
            make_search(name, Parameters(), aims);
        } catch (const InputError &error) {
            message = error.what();
        }
        BOOST_TEST(message == "search '" + std::string(name) +
                                  "' reads no objectives, but fitness; nsga2 and nslc read them");
    }
    for (const auto name : {"nsga2", "nslc"}) BOOST_CHECK_NO_THROW(make_search(name, Parameters(), aims));
    const Aims novelty{{{"novelty", Objective::Value::novelty, {}}}, {}};
    BOOST_CHECK_NO_THROW(make_search("nsga2", Parameters(), novelty));
    BOOST_CHECK_THROW(make_search("nslc", Parameters(), novelty), InputError);
}

BOOST_AUTO_TEST_CASE(every_search_keeps_its_generations_whole) {
    for (const auto name : search_names()) BOOST_TEST_CONTEXT(name) {
            ToyRun run(name, of(30), 1);
            std::set<std::int64_t> ids;
            std::size_t archived = 0;
            for (int generation = 0; generation < 15; ++generation) {
                for (const Genome &genome : run.population.genomes)
                    BOOST_TEST_REQUIRE(ids.insert(genome.id).second);
                run.step();
                BOOST_TEST(run.population.generation == generation + 1);
                check_generation(run);
                BOOST_TEST(run.search->archive().size() >= archived);
                archived = run.search->archive().size();
                for (const ArchiveEntry &entry : run.search->archive())
                    BOOST_TEST(ids.contains(entry.genome));
            }
            BOOST_TEST((archived > 0) == run.search->keeps_archive());
        }
}

BOOST_AUTO_TEST_CASE(every_search_works_at_its_limits) {
    const auto constant = [](const Evaluation &evaluation) {
        return [evaluation](const Genome &) { return evaluation; };
    };
    const auto first_only = [](const Genome &genome) {
        return genome.id == 0 ? Evaluation{1, {0, 0}, 1} : Evaluation{};
    };
    const std::vector<std::pair<int, Judgement>> limits{
        {2, by_weights},                              // the smallest population
        {20, constant({})},                           // all invalid
        {2, constant({})},                            //
        {20, first_only},                             // one valid
        {20, constant({0, {0, 0}, 1})},               // all equal, none moves
        {20, constant({1e100, {1e100, -1e100}, 1})}}; // all equal and far away
    for (const auto name : search_names())
        for (const auto &[size, judge] : limits) BOOST_TEST_CONTEXT(name << ", " << size) {
                ToyRun run(name, of(size), 1, judge);
                for (int generation = 0; generation < 6; ++generation) {
                    run.step();
                    check_generation(run);
                }
            }
}

BOOST_AUTO_TEST_CASE(every_search_is_a_function_of_its_seed) {
    for (const auto name : search_names()) BOOST_TEST_CONTEXT(name) {
            const auto once = ToyRun(name, of(20), 3).steps(8);
            BOOST_TEST((ToyRun(name, of(20), 3).steps(8) == once));
            BOOST_TEST((ToyRun(name, of(20), 4).steps(8) != once));
        }
}

BOOST_AUTO_TEST_CASE(every_search_resumes_as_if_it_had_not_been_stopped) {
    for (const auto name : search_names())
        for (const int stop : {0, 1, 7}) BOOST_TEST_CONTEXT(name << ", " << stop) {
                ToyRun through(name, of(20), 5), stopped(name, of(20), 5);
                through.steps(stop);
                stopped.steps(stop);
                const std::string bytes = saved(stopped);
                const auto archive = archive_of(*stopped.search);
                stopped.search = make_search(name, stopped.parameters);
                StateReader reader(bytes);
                stopped.search->load(stopped.population, archive, reader);
                reader.done();
                BOOST_TEST((stopped.steps(9) == through.steps(9)));
                BOOST_TEST((saved(stopped) == saved(through)));
            }
}

BOOST_AUTO_TEST_CASE(every_state_reads_back_to_the_same_bytes_and_is_refused_if_cut_short) {
    for (const auto name : search_names()) BOOST_TEST_CONTEXT(name) {
            ToyRun run(name, of(6), 2);
            run.steps(4);
            const std::string bytes = saved(run);
            StateReader reader(bytes);
            // What the search held before is gone.
            ToyRun other(name, of(6), 9);
            other.steps(2);
            other.population = run.population;
            const auto archive = archive_of(*run.search);
            other.search->load(other.population, archive, reader);
            BOOST_TEST((saved(other) == bytes));
            BOOST_TEST((archive_of(*other.search) == archive));
            const std::size_t step = bytes.size() / 500 + 1;
            for (std::size_t length = 0; length < bytes.size(); length += step) {
                StateReader cut(std::string_view(bytes).substr(0, length));
                BOOST_REQUIRE_THROW(other.search->load(other.population, archive, cut), InputError);
            }
        }
}

BOOST_AUTO_TEST_CASE(damaged_state_is_refused_or_ends_in_a_named_error_but_never_goes_unseen) {
    for (const auto name : search_names()) BOOST_TEST_CONTEXT(name) {
            ToyRun run(name, of(4), 2);
            run.steps(3);
            const std::string bytes = saved(run);
            Stream stream = specimens::stream(1);
            for (int round = 0; round < 400; ++round) {
                std::string damaged = bytes;
                char &at = damaged[stream.below(static_cast<std::uint32_t>(bytes.size()))];
                at = static_cast<char>(at ^ 1 << stream.below(8));
                ToyRun other(name, of(4), 2);
                other.population = run.population;
                StateReader reader(damaged);
                try {
                    other.search->load(other.population, archive_of(*run.search), reader);
                    BOOST_TEST_REQUIRE((saved(other) == damaged));
                    other.step();
                    check_generation(other);
                } catch (const Error &) {
                }
            }
        }
}

BOOST_AUTO_TEST_CASE(unsuitable_evaluations_are_the_users_error) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::vector<Evaluation>> unsuitable{
        {{1, {}, 1}, {1, {1, 2}, 1}}, {{1, {1, 2}, 1}, {1, {1}, 1}}, {{1, {1, 2}, 1}, {1, {nan, 2}, 1}}};
    for (const auto name : search_names())
        for (const auto &evaluations : unsuitable) {
            ToyRun run(name, of(2), 1);
            if (reads_behaviour(name))
                BOOST_CHECK_THROW(run.search->score(run.population, evaluations), InputError);
            else
                BOOST_CHECK_NO_THROW(run.search->score(run.population, evaluations));
            // Too few evaluations are the program's.
            BOOST_CHECK_THROW(run.search->score(run.population, {}), InternalError);
        }
    // Another length later in the run.
    for (const auto name : search_names())
        if (reads_behaviour(name)) {
            ToyRun run(name, of(2), 1);
            run.step();
            BOOST_CHECK_THROW(run.search->score(run.population, std::vector<Evaluation>(2, {1, {1}, 1})),
                              InputError);
        }
}
