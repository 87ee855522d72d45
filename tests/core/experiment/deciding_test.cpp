// SPDX-License-Identifier: MIT
#include "experiment/deciding.h"

#include <boost/test/unit_test.hpp>

#include <set>

using namespace planula;

BOOST_AUTO_TEST_CASE(all_parameters_decide_lives_but_lengths_and_statistics) {
    std::set<std::string_view> others;
    for (const ParameterRow &row : parameter_rows())
        if (!decides_lives(row)) others.insert(row.name);
    BOOST_TEST((others == std::set<std::string_view>{"seeds", "generations", "confidence",
                                                     "bootstrap_resamples", "exploit_bound", "unrest_bound",
                                                     "witness_nudge", "witness_nudges"}));
}

BOOST_AUTO_TEST_CASE(what_is_not_shown_has_a_reason) {
    for (const ParameterRow &row : parameter_rows())
        BOOST_TEST(why_not_shown(row.name).empty() == decides_lives(row), row.name);
    BOOST_TEST(why_not_shown("no_such") == "");
}
