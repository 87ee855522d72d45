// SPDX-License-Identifier: MIT
#include "evaluation/example_life.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// Whether a field of the life differs from its initial value, by the order of life.inl.
std::vector<bool> filled(const Life &life) {
    const Life initial;
    std::vector<bool> differs;
#define FIELD(type, name, first, unit, known, meaning) differs.push_back(life.name != initial.name);
#include "evaluation/life.inl"
    return differs;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_viable_example_fills_every_field_that_scripts_see_and_that_is_known) {
    for (const KnownAfter stage : {KnownAfter::growth, KnownAfter::locomotion}) {
        const std::vector<bool> is_filled = filled(example_life(Outcome::viable, stage, {}));
        for (std::size_t i = 0; i < is_filled.size(); ++i) {
            const LifeField &field = life_fields()[i];
            BOOST_TEST(is_filled[i] == (field.is_shown && field.known <= stage), field.name);
        }
    }
}

BOOST_AUTO_TEST_CASE(an_example_has_the_outcome_and_no_place_unless_viable) {
    for (const Outcome outcome : {Outcome::died_out, Outcome::too_small, Outcome::overgrown,
                                  Outcome::never_settled, Outcome::exploded}) {
        const Life life = example_life(outcome, KnownAfter::locomotion, {});
        BOOST_TEST(name_of(life.outcome) == name_of(outcome));
        BOOST_TEST(life.displacement() == 0);
        BOOST_TEST(life.path.empty());
    }
}

BOOST_AUTO_TEST_CASE(the_path_of_an_example_leads_from_rest_to_finish) {
    Parameters parameters;
    const Life life = example_life(Outcome::viable, KnownAfter::locomotion, parameters);
    BOOST_TEST(life.path.size() ==
               static_cast<std::size_t>(parameters.gait.locomotion_steps / parameters.gait.path_interval) +
                   1);
    BOOST_TEST((life.path.front() == life.rest && life.path.back() == life.finish));
}
