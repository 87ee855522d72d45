// SPDX-License-Identifier: MIT
#include "body/mesh.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// The vertices of the contour that starts with this outline link.
std::vector<int> contour(const std::vector<OutlineLink> &links, int start) {
    std::vector<int> vertices;
    int at = start;
    do {
        vertices.push_back(links[at].a);
        at = links[at].next;
    } while (at != start && vertices.size() < 100);
    return vertices;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_outline_has_the_body_on_its_left) {
    // A square of two triangles around 0-1-3-2 (0 south-west, 1 south-east, 2 north-west, 3 north-east).
    const Mesh square{{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}, {{0, 1, 2}, {1, 3, 2}}};
    const auto links = outline(square);
    BOOST_TEST(links.size() == 4u);
    BOOST_TEST(contour(links, 0) == (std::vector<int>{0, 1, 3, 2}));
    for (std::size_t i = 0; i < links.size(); ++i) {
        BOOST_TEST(links[i].solid);
        BOOST_TEST(links[links[i].next].previous == static_cast<int>(i));
        BOOST_TEST(links[links[i].next].a == links[i].b);
    }
}

BOOST_AUTO_TEST_CASE(a_chain_is_outline_without_contour_from_low_to_high) {
    const auto links = outline(Mesh{{{0, 1}, {1, 2}}, {}});
    BOOST_TEST(links.size() == 2u);
    for (const OutlineLink &link : links) {
        BOOST_TEST(link.a < link.b);
        BOOST_TEST(!link.solid);
        BOOST_TEST(link.next == -1);
        BOOST_TEST(link.previous == -1);
    }
}

BOOST_AUTO_TEST_CASE(contours_that_touch_in_a_vertex_stay_apart) {
    // A bow tie: two triangles that share only vertex 2.
    const Mesh bow{{{0, 1}, {0, 2}, {1, 2}, {2, 3}, {2, 4}, {3, 4}}, {{0, 1, 2}, {2, 3, 4}}};
    const auto links = outline(bow);
    BOOST_TEST(links.size() == 6u);
    for (int i = 0; i < 6; ++i) BOOST_TEST(contour(links, i).size() == 3u);
}

BOOST_AUTO_TEST_CASE(the_rim_of_a_hole_is_outline_like_any_other) {
    // A ring: inner triangle 0-1-2 empty, outer 3-4-5, six triangles between (3, 4, 5 opposite to edges of
    // it).
    const Mesh ring{{{0, 1},
                     {0, 2},
                     {0, 3},
                     {0, 4},
                     {0, 5},
                     {1, 2},
                     {1, 3},
                     {1, 4},
                     {2, 4},
                     {2, 5},
                     {3, 4},
                     {3, 5},
                     {4, 5}},
                    {{0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {0, 2, 5}, {0, 5, 3}}};
    const auto links = outline(ring);
    int rims = 0;
    std::vector<char> seen(links.size(), 0);
    for (int i = 0; i < static_cast<int>(links.size()); ++i) {
        if (seen[i] || !links[i].solid) continue;
        ++rims;
        for (int at = i; !seen[at]; at = links[at].next) seen[at] = 1;
    }
    BOOST_TEST(rims == 2);
}

BOOST_AUTO_TEST_CASE(neighbours_are_listed_both_ways_in_order) {
    const auto lists = neighbours(Mesh{{{0, 2}, {1, 2}}, {}}, 4);
    BOOST_TEST(lists[0] == std::vector<int>{2});
    BOOST_TEST(lists[2] == (std::vector<int>{0, 1}));
    BOOST_TEST(lists[3].empty());
}
