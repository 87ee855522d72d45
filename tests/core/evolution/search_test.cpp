// SPDX-License-Identifier: MIT
#include "evolution/search.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace planula;

BOOST_AUTO_TEST_CASE(every_name_makes_its_search) {
    for (const auto name : search_names()) BOOST_TEST(make_search(name, Parameters()) != nullptr);
    BOOST_TEST(!make_search("neat", Parameters())->keeps_archive());
    BOOST_TEST(make_search("novelty", Parameters())->keeps_archive());
    BOOST_TEST(make_search("novelty", Parameters())->archive_threshold() == 0.5);
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_answered_with_the_nearest_or_with_all) {
    const auto message_for = [](std::string_view name) -> std::string {
        try {
            make_search(name, Parameters());
        } catch (const InputError &error) {
            return error.what();
        }
        return "";
    };
    BOOST_TEST(message_for("novelti") == "no search is called 'novelti'; did you mean 'novelty'?");
    BOOST_TEST(message_for("simulated annealing") ==
               "no search is called 'simulated annealing'; there are 'neat', 'novelty'");
}
