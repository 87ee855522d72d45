// SPDX-License-Identifier: MIT
#include "body/mesh.h"

#include "body/connect.h"
#include "support/points.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>

using namespace planula;

namespace {

/// How many closed contours the solid links of an outline make; each vertex must be on one of them alone.
int contours(const std::vector<OutlineLink> &links) {
    std::map<int, int> next;
    for (const OutlineLink &link : links)
        if (link.solid) BOOST_TEST(next.emplace(link.a, link.b).second, "vertex " << link.a);
    int count = 0;
    for (; !next.empty(); ++count)
        for (auto at = next.begin(); at != next.end();) {
            const int end = at->second;
            next.erase(at);
            at = next.find(end);
        }
    return count;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_outline_has_the_body_on_its_left) {
    // A square of two triangles around 0-1-3-2 (0 south-west, 1 south-east, 2 north-west, 3 north-east).
    const Mesh square{{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}, {{0, 1, 2}, {1, 3, 2}}};
    std::vector<Link> directed;
    for (const OutlineLink &link : outline(square)) {
        BOOST_TEST(link.solid);
        directed.push_back({link.a, link.b});
    }
    BOOST_TEST((directed == std::vector<Link>{{0, 1}, {2, 0}, {1, 3}, {3, 2}}));
}

BOOST_AUTO_TEST_CASE(a_chain_is_outline_from_low_to_high) {
    const auto links = outline(Mesh{{{0, 1}, {1, 2}}, {}});
    BOOST_TEST(links.size() == 2u);
    for (const OutlineLink &link : links) {
        BOOST_TEST(link.a < link.b);
        BOOST_TEST(!link.solid);
    }
}

BOOST_AUTO_TEST_CASE(bodies_that_touch_in_a_vertex_keep_their_outlines) {
    // A bow tie: two triangles that share only vertex 2.
    const Mesh bow{{{0, 1}, {0, 2}, {1, 2}, {2, 3}, {2, 4}, {3, 4}}, {{0, 1, 2}, {2, 3, 4}}};
    const auto links = outline(bow);
    BOOST_TEST(links.size() == 6u);
    for (const OutlineLink &link : links) BOOST_TEST(link.solid);
}

BOOST_AUTO_TEST_CASE(the_outline_of_any_body_is_what_has_not_two_triangles) {
    for (int cells = 1; cells <= 50; ++cells) {
        const Mesh mesh = connect(test::scatter(cells, 3), 2.5);
        const std::vector<OutlineLink> links = outline(mesh);
        std::size_t place = 0;
        for (const auto &[a, b] : mesh.links) {
            bool up = false, down = false;
            for (const Triangle &t : mesh.triangles)
                for (const auto &[from, to] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}})
                    up = up || (from == a && to == b), down = down || (from == b && to == a);
            if (up && down) continue;
            BOOST_REQUIRE(place < links.size());
            const OutlineLink &link = links[place++];
            BOOST_TEST((link.a == (down ? b : a) && link.b == (down ? a : b) && link.solid == (up || down)));
        }
        BOOST_TEST(place == links.size());
    }
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
    BOOST_TEST(contours(outline(ring)) == 2);
}

BOOST_AUTO_TEST_CASE(neighbours_are_listed_both_ways_in_order) {
    const Neighbours lists(std::vector<Link>{{0, 2}, {0, 4}, {1, 2}, {2, 3}}, 6);
    const auto holds = [&](int cell, const std::vector<int> &list) {
        return std::ranges::equal(lists[cell], list);
    };
    BOOST_TEST(holds(0, {2, 4}));
    BOOST_TEST(holds(1, {2}));
    BOOST_TEST(holds(2, {0, 1, 3}));
    BOOST_TEST(holds(3, {2}));
    BOOST_TEST(holds(4, {0}));
    BOOST_TEST(holds(5, {}));
}
