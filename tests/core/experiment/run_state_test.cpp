// SPDX-License-Identifier: MIT
#include "experiment/run_state.h"

#include "base/error.h"
#include "core/experiment/swimmers.h"
#include "evolution/population_state.h"
#include "experiment/signature.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

Spec small(std::string_view search, Actuation actuation) {
    Spec spec = swimmers(search, actuation, 8, 100);
    spec.parameters.novelty.archive_threshold = 0.01;
    return spec;
}

constexpr std::uint64_t seed = 4;

std::string saved(const RunState &state) {
    StateWriter writer;
    save(state, writer);
    return writer.bytes();
}

using Archive = std::vector<ArchiveEntry>;

Archive archive_of(const RunState &state) {
    return {state.search->archive().begin(), state.search->archive().end()};
}

RunState loaded(const Spec &spec, const std::string &bytes, const Archive &archive) {
    StateReader reader(bytes);
    RunState state = load_run_state(spec, archive, reader);
    reader.done();
    return state;
}

/// Runs to the end, saved, thrown away and loaded again whenever `evaluations` more have been asked for.
std::string signature(const Spec &spec, int evaluations) {
    Signature hash;
    const auto observe = [&](const Generation &generation) { hash.observe(generation); };
    RunState state = begin(spec, seed);
    for (int allowed = evaluations;; allowed += evaluations) {
        int asked = 0;
        try {
            run(
                spec, seed, 1, state, observe, [](const RunState &) {}, [&] { return asked++ == allowed; });
            return hash.hex();
        } catch (const Stopped &) {
            state = loaded(spec, saved(state), archive_of(state));
        }
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(a_run_stopped_anywhere_and_loaded_goes_on_to_the_same_results) {
    for (const std::string search : {"neat", "novelty"})
        for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
            const Spec spec = small(search, actuation);
            const std::string whole = signature(spec, 1'000'000);
            for (const int evaluations : {8, 11, 21}) BOOST_TEST(signature(spec, evaluations) == whole);
        }
}

BOOST_AUTO_TEST_CASE(searches_that_keep_individuals_go_on_with_them) {
    for (const std::string search : {"nsga2", "nslc", "map-elites"}) {
        const Spec spec = small(search, Actuation::oscillator);
        BOOST_TEST(signature(spec, 11) == signature(spec, 1'000'000));
    }
}

BOOST_AUTO_TEST_CASE(a_saved_state_has_the_results_of_the_mothers) {
    for (const std::string_view search : search_names()) {
        const Spec spec = small(search, Actuation::oscillator);
        RunState state = begin(spec, seed);
        const auto compare = [&](const RunState &now) {
            const RunState again = loaded(spec, saved(now), archive_of(now));
            BOOST_TEST((saved(again) == saved(now)));
            for (const Genome &child : now.population.genomes) {
                const MotherLife *mother = now.mothers.of(child), *found = again.mothers.of(child);
                BOOST_TEST((mother ? found && *found == *mother : !found));
            }
        };
        run(
            spec, seed, 1, state, [](const Generation &) {}, compare);
    }
}

BOOST_AUTO_TEST_CASE(individuals_kept_from_another_run_are_refused) {
    for (const std::string search : {"nsga2", "map-elites"}) {
        // Two runs, stopped after one generation and after three.
        const auto stopped = [&](const Spec &spec, int generations) {
            RunState state = begin(spec, seed);
            const auto stop = [&] { return state.population.generation == generations; };
            BOOST_CHECK_THROW(
                run(
                    spec, seed, 1, state, [](const Generation &) {}, [](const RunState &) {}, stop),
                Stopped);
            return state;
        };
        const Spec spec = small(search, Actuation::oscillator);
        const RunState early = stopped(spec, 1), late = stopped(spec, 3);
        BOOST_TEST(late.search->kept_genomes().size() > 0u);
        // The population of the early run and those whom another one kept.
        const auto load_mixed = [&](const RunState &kept) {
            StateWriter writer;
            save(early.population, writer);
            kept.search->save(kept.population, writer);
            kept.mothers.save(writer);
            loaded(spec, writer.bytes(), archive_of(kept));
        };
        load_mixed(early);
        BOOST_CHECK_THROW(load_mixed(late), InputError); // genomes that are not born yet
    }
}

BOOST_AUTO_TEST_CASE(a_stop_leaves_the_state_before_the_abandoned_generation) {
    const Spec spec = small("novelty", Actuation::oscillator);
    RunState state = begin(spec, seed);
    std::string before;
    const auto stop = [asked = 0]() mutable { return asked++ == 13; };
    BOOST_CHECK_THROW(run(
                          spec, seed, 2, state, [](const Generation &) {},
                          [&](const RunState &now) { before = saved(now); }, stop),
                      Stopped);
    BOOST_TEST(state.population.generation == 1);
    BOOST_TEST((saved(state) == before));
}

BOOST_AUTO_TEST_CASE(the_state_of_another_setting_is_refused) {
    const Spec spec = small("neat", Actuation::oscillator);
    const std::string bytes = saved(begin(spec, seed));
    loaded(spec, bytes, {});
    BOOST_CHECK_THROW(loaded(small("novelty", Actuation::oscillator), bytes, {}), InputError);
    BOOST_CHECK_THROW(loaded(small("neat", Actuation::grn), bytes, {}), InputError);
}
