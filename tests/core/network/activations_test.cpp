// SPDX-License-Identifier: MIT
#include "network/activations.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// Cell i has 10 i, 10 i + 1, … at its nodes.
Activations counted(int nodes, int cells) {
    Activations result(nodes, cells);
    for (int cell = 0; cell < cells; ++cell)
        for (int node = 0; node < nodes; ++node) result.at(cell, node) = 10 * cell + node;
    return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_cell_has_a_place_of_its_own_for_every_node) {
    const Activations activations = counted(3, 17);
    for (int cell = 0; cell < 17; ++cell)
        for (int node = 0; node < 3; ++node) BOOST_TEST(activations.at(cell, node) == 10 * cell + node);
}

BOOST_AUTO_TEST_CASE(a_daughter_has_the_activations_of_her_mother_and_others_keep_theirs) {
    Activations activations = counted(3, 1);
    for (int daughter = 1; daughter < 20; ++daughter) {
        activations.append_copy(daughter / 2);
        BOOST_REQUIRE(activations.cells() == daughter + 1);
        for (int node = 0; node < 3; ++node) {
            BOOST_TEST(activations.at(daughter, node) == activations.at(daughter / 2, node));
            activations.at(daughter, node) = 10 * daughter + node;
        }
    }
    for (int cell = 0; cell < 20; ++cell) BOOST_TEST(activations.at(cell, 2) == 10 * cell + 2);
}

BOOST_AUTO_TEST_CASE(removed_cells_leave_no_gap) {
    Activations activations = counted(2, 19);
    std::vector<char> marks(19);
    for (const int dying : {0, 3, 8, 9, 18}) marks[dying] = 1;
    activations.remove(marks);
    BOOST_REQUIRE(activations.cells() == 14);
    int cell = 0;
    for (int i = 0; i < 19; ++i) {
        if (marks[i]) continue;
        BOOST_TEST(activations.at(cell, 1) == 10 * i + 1);
        ++cell;
    }
}
