// SPDX-License-Identifier: MIT
#include "evaluation/observations.h"

#include "evaluation/example_life.h"
#include "parameters/parameters.h"

#include <boost/test/unit_test.hpp>

#include <set>

using namespace planula;

BOOST_AUTO_TEST_CASE(every_name_is_used_once_among_fields_observations_and_parameters) {
    std::set<std::string_view> names{"displacement"};
    for (const LifeField &field : life_fields()) BOOST_TEST(names.insert(field.name).second, field.name);
    for (const ObservationRow &row : observation_rows()) {
        BOOST_TEST(names.insert(row.name).second, row.name);
        BOOST_TEST((!row.meaning.empty() && (row.exists.holds != nullptr) == !row.exists.where.empty()));
    }
    for (const ParameterRow &row : parameter_rows()) BOOST_TEST(!names.contains(row.name), row.name);
}

BOOST_AUTO_TEST_CASE(a_set_has_what_was_added) {
    ObservationSet set;
    BOOST_TEST(set.empty());
    set.add(Observation::period);
    BOOST_TEST((set.has(Observation::period) && !set.has(Observation::work) && !set.empty()));
}

BOOST_AUTO_TEST_CASE(an_example_tells_what_it_is_asked_for) {
    ObservationSet set;
    for (std::size_t i = 0; i < observation_rows().size(); ++i) set.add(static_cast<Observation>(i));
    const Life life = example_life(Outcome::viable, KnownAfter::locomotion, {}, set);
    const Observations initial;
#define OBSERVATION(type, name, first, unit, known, exists, meaning)                                         \
    BOOST_TEST((life.observations.name != initial.name), #name);
#include "evaluation/observations.inl"
    const Life grown = example_life(Outcome::viable, KnownAfter::growth, {}, set);
    BOOST_TEST((grown.observations.work == 0 && !grown.observations.body.empty()));
    BOOST_TEST((example_life(Outcome::viable, KnownAfter::locomotion, {}).observations == initial));
}
