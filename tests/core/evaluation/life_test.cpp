// SPDX-License-Identifier: MIT
#include "evaluation/life.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

using namespace planula;

BOOST_AUTO_TEST_CASE(each_field_is_visited_once_in_the_order_of_the_list) {
    Life life;
    std::set<const void *> visited;
    each_field(life, [&](auto &field) { BOOST_TEST(visited.insert(&field).second); });
    BOOST_TEST(visited.size() == life_fields().size());
    std::size_t i = 0;
#define FIELD(type, member, initial, unit, known, meaning)                                                   \
    BOOST_TEST(visited.contains(&life.member));                                                              \
    BOOST_TEST(life_fields()[i++].name == #member);
#include "evaluation/life.inl"
}

BOOST_AUTO_TEST_CASE(a_field_is_found_by_its_name) {
    for (const LifeField &field : life_fields()) {
        BOOST_TEST(life_field(field.name).meaning == field.meaning);
        BOOST_TEST(!field.meaning.empty());
    }
    BOOST_TEST((life_field("cells").known == KnownAfter::growth));
    BOOST_TEST((life_field("path").known == KnownAfter::locomotion));
    BOOST_TEST(life_field("finish").is_shown);
    BOOST_TEST(!life_field("shape").is_shown);
}

BOOST_AUTO_TEST_CASE(lives_are_equal_if_every_field_is) {
    const Life life;
    Life other;
    BOOST_TEST((life == other));
    other.late_actuation = 1;
    BOOST_TEST(!(life == other));
}

BOOST_AUTO_TEST_CASE(the_displacement_is_the_distance_from_rest_to_finish) {
    Life life;
    BOOST_TEST(life.displacement() == 0);
    life.rest = {1, 2}, life.finish = {4, 6};
    BOOST_TEST(life.displacement() == 5);
}
