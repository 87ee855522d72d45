// SPDX-License-Identifier: MIT
#include "experiment/spec.h"

#include "base/error.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

Spec good() {
    Spec spec;
    spec.name = "osc-aq_1";
    spec.actuation_range = 0.4;
    spec.environment = specimens::water();
    spec.judge = [](const Life &) { return Evaluation{}; };
    return spec;
}

void refused(const Spec &spec, const std::string &rule) {
    BOOST_CHECK_EXCEPTION(check_spec(spec), InputError, [&](const InputError &error) {
        return std::string(error.what()).find(rule) != std::string::npos;
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_complete_setting_is_accepted) { check_spec(good()); }

BOOST_AUTO_TEST_CASE(an_invalid_setting_is_refused_with_the_rule) {
    for (const char *name : {"", "a b", "../up", "x/y", "ä"}) {
        Spec spec = good();
        spec.name = name;
        refused(spec, "the name of a setting");
    }
    check_name("a thing", "x-1_Y");
    BOOST_CHECK_EXCEPTION(check_name("a thing", "x/y"), InputError, [](const InputError &error) {
        return std::string(error.what()) ==
               "the name of a thing is 1 to 100 letters, digits, '-' and '_', not 'x/y'";
    });
    Spec wide = good();
    wide.actuation_range = 1.5;
    refused(wide, "actuation_range is between 0 and 0.9 rest lengths, not 1.5");
    Spec lost = good();
    lost.search = "noveltey";
    refused(lost, "novelty");
    Spec falling = good();
    falling.environment.gravity = 5;
    refused(falling, "fall for ever");
    Spec mute = good();
    mute.judge = nullptr;
    refused(mute, "no fitness");
    Spec unborn = good();
    unborn.start.emplace();
    unborn.start->generations = 0;
    refused(unborn, "start takes at least 1 generation, not 0");
    unborn.start->generations = 1;
    refused(unborn, "has no behaviour");
    Spec inconsistent = good();
    inconsistent.parameters.gait.period_shortest = 500;
    refused(inconsistent, "period_shortest");
}
