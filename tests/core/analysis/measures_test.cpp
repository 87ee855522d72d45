// SPDX-License-Identifier: MIT
#include "analysis/measures.h"

#include "base/error.h"
#include "core/storage/temporary_folder.h"

#include <boost/test/unit_test.hpp>

#include <set>

using namespace planula;

BOOST_AUTO_TEST_CASE(every_number_of_a_run_and_of_its_last_generation_is_a_measure_once) {
    std::set<std::string> names;
    for (const Measure &measure : measures()) {
        BOOST_TEST(names.insert(measure.name).second, measure.name);
        BOOST_TEST(measure.meaning != "", measure.name);
        BOOST_TEST(measure_called(measure.name).unit == measure.unit);
    }
    for (const char *name :
         {"best_fitness", "best_cells", "size_entropy", "mean_fitness", "species", "cyclic"})
        BOOST_TEST(names.contains(name), name);
    for (const char *name : {"setting", "seed", "generation", "generations"})
        BOOST_TEST(!names.contains(name), name);
}

BOOST_AUTO_TEST_CASE(a_name_of_both_tables_is_that_of_the_run) {
    const RunRow run{.best_fitness = 7};
    const GenerationRow last{.best_fitness = 5, .mean_fitness = 2, .species = 3};
    BOOST_TEST(measured(measure_called("best_fitness"), run, last).value() == 7);
    BOOST_TEST(measured(measure_called("mean_fitness"), run, last).value() == 2);
    BOOST_TEST(measured(measure_called("species"), run, last).value() == 3);
    BOOST_TEST(!measured(measure_called("heredity_cells"), run, last).has_value());
}

BOOST_AUTO_TEST_CASE(an_unknown_measure_is_answered_with_the_nearest_and_all) {
    const std::string said = message_of<InputError>([] { measure_called("best_fitnes"); });
    BOOST_TEST(
        said.starts_with("there is no measure 'best_fitnes'; did you mean 'best_fitness'?\nmeasures are"),
        said);
    BOOST_TEST(said.find("side_switches") != said.npos);
}

BOOST_AUTO_TEST_CASE(names_and_units_in_words) {
    BOOST_TEST(measure_called("best_fitness").words() == "best fitness");
    BOOST_TEST(measure_called("best_displacement").unit_words() == " cells");
    BOOST_TEST(measure_called("best_fitness").unit_words() == ""); // it is what a script says
    BOOST_TEST(measure_called("best_cells").unit_words() == " cells");
    BOOST_TEST(measure_called("elongation").unit_words() == "");
}
