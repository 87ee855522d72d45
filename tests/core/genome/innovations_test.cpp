// SPDX-License-Identifier: MIT
#include "genome/innovations.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_link_keeps_its_number_and_direction_matters) {
    Innovations innovations(5);
    BOOST_TEST(innovations.link(0, 3) == 0);
    BOOST_TEST(innovations.link(3, 0) == 1);
    BOOST_TEST(innovations.link(1, 3) == 2);
    BOOST_TEST(innovations.link(0, 3) == 0);
    BOOST_TEST(innovations.links() == 3);
}

BOOST_AUTO_TEST_CASE(splits_of_a_link_are_remembered_in_order) {
    Innovations innovations(5);
    BOOST_TEST(innovations.splits(0, 3).empty());
    BOOST_TEST(innovations.new_split(0, 3) == 5);
    BOOST_TEST(innovations.new_split(1, 3) == 6);
    BOOST_TEST(innovations.new_split(0, 3) == 7);
    const std::vector<int> expected{5, 7};
    const auto splits = innovations.splits(0, 3);
    BOOST_TEST(std::equal(splits.begin(), splits.end(), expected.begin(), expected.end()));
    BOOST_TEST(innovations.splits(3, 0).empty());
    BOOST_TEST(innovations.next_node() == 8);
}

BOOST_AUTO_TEST_CASE(the_ends_of_a_link_and_the_link_split_for_a_node_are_on_record) {
    Innovations innovations(5);
    for (const int from : {0, 3, 0}) innovations.link(from, 4);
    for (const int from : {0, 3, 0}) innovations.new_split(from, 4);
    BOOST_TEST(innovations.first_node() == 5);
    BOOST_TEST(innovations.links() == 2);
    for (const int innovation : {0, 1}) {
        BOOST_TEST(innovations.link_ends(innovation).from == 3 * innovation);
        BOOST_TEST(innovations.link_ends(innovation).to == 4);
    }
    for (const int node : {5, 6, 7}) {
        BOOST_TEST(innovations.split_ends(node).from == (node == 6 ? 3 : 0));
        BOOST_TEST(innovations.split_ends(node).to == 4);
    }
}

namespace {

/// A record of three links and three splits, two of them of one link.
Innovations sample() {
    Innovations innovations(5);
    for (const int from : {0, 1, 2}) innovations.link(from, 3);
    for (const int from : {0, 1, 0}) innovations.link(from, innovations.new_split(from, 3));
    return innovations;
}

std::string saved(const Innovations &innovations) {
    StateWriter writer;
    innovations.save(writer);
    return writer.bytes();
}

Innovations loaded(const std::string &bytes) {
    StateReader reader(bytes);
    Innovations innovations = Innovations::load(reader);
    reader.done();
    return innovations;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_saved_record_continues_as_if_it_had_not_been_saved) {
    Innovations kept = sample(), back = loaded(saved(kept));
    BOOST_TEST(saved(back) == saved(kept));
    for (Innovations *record : {&kept, &back}) {
        BOOST_TEST(record->links() == 6);
        BOOST_TEST(record->link(2, 3) == 2);
        BOOST_TEST(record->link(1, 6) == 4);
        BOOST_TEST(record->link(9, 3) == 6);
        BOOST_TEST(record->splits(0, 3).size() == 2u);
        BOOST_TEST(record->splits(0, 3)[1] == 7);
        BOOST_TEST(record->new_split(2, 3) == 8);
    }
}

BOOST_AUTO_TEST_CASE(a_record_that_contradicts_itself_is_refused) {
    const auto refused = [](const StateWriter &writer) {
        BOOST_CHECK_THROW(loaded(writer.bytes()), InputError);
    };
    const auto head = [](int first_node, int splits) {
        StateWriter writer;
        writer.group("innovations").integer(first_node).integer(splits);
        return writer;
    };
    // A link twice, a link to a node that is not there, a split of a link to a later node, no inputs at all.
    refused(head(5, 0).integer(2).integer(0).integer(3).integer(0).integer(3));
    refused(head(5, 0).integer(1).integer(0).integer(5));
    refused(head(5, 1).integer(0).integer(5).integer(0));
    refused(head(-1, 0).integer(0));
}
