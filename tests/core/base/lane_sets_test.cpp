// SPDX-License-Identifier: MIT
#include "base/lane_sets.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace planula;

BOOST_AUTO_TEST_CASE(the_widest_lanes_are_used_unless_others_are_chosen) {
    const LaneSet widest = lane_sets().back();
    BOOST_TEST((lane_sets().front() == LaneSet::scalar));
    BOOST_TEST((chosen_lanes() == widest));
    choose_lanes("scalar");
    BOOST_TEST((chosen_lanes() == LaneSet::scalar));
    choose_lanes(name_of(widest));
    BOOST_TEST((chosen_lanes() == widest));
}

BOOST_AUTO_TEST_CASE(unknown_lanes_are_refused_with_the_nearest_name) {
    BOOST_CHECK_EXCEPTION(choose_lanes("skalar"), InputError, [](const InputError &error) {
        return std::string(error.what()) == "this processor has no lanes 'skalar'; did you mean 'scalar'?";
    });
}
