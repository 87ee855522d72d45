// SPDX-License-Identifier: MIT
#include "evolution/pareto.h"

#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace planula;
using boost::test_tools::per_element;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Fronts = std::vector<std::vector<int>>;

/// The twelve solutions of the worked example Min-Ex in Deb (2001), "Multi-objective optimization using
/// evolutionary algorithms", chapter 6: 1 to 6, then a to f. Both objectives are minimised there.
std::vector<Objectives> min_ex() {
    std::vector<Objectives> solutions;
    for (const auto &[x1, x2] : {std::pair{0.31, 0.89},
                                 {0.43, 1.92},
                                 {0.22, 0.56},
                                 {0.59, 3.63},
                                 {0.66, 1.41},
                                 {0.83, 2.51},
                                 {0.21, 0.24},
                                 {0.79, 2.14},
                                 {0.51, 2.32},
                                 {0.27, 0.87},
                                 {0.58, 1.62},
                                 {0.24, 1.05}})
        solutions.push_back({-x1, -(1 + x2) / x1});
    return solutions;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_solution_dominates_if_it_is_nowhere_lower_and_somewhere_higher) {
    BOOST_TEST(dominates({2, 2}, {1, 2}));
    BOOST_TEST(!dominates({1, 2}, {2, 2}));
    BOOST_TEST(!dominates({1, 2}, {1, 2}));
    BOOST_TEST((!dominates({1, 2}, {2, 1}) && !dominates({2, 1}, {1, 2})));
    // A feasible solution dominates one that is not; of two infeasible ones neither dominates.
    BOOST_TEST(dominates({0, 0}, {}));
    BOOST_TEST(!dominates({}, {0, 0}));
    BOOST_TEST(!dominates({}, {}));
}

BOOST_AUTO_TEST_CASE(the_fronts_of_debs_example_are_his) {
    // {5, a, e}, {1, 3, b, d}, {2, 6, c, f}, {4}.
    const Fronts fronts = non_dominated_fronts(min_ex());
    BOOST_REQUIRE(fronts.size() == 4u);
    BOOST_TEST(fronts[0] == (std::vector{4, 6, 10}), per_element());
    BOOST_TEST(fronts[1] == (std::vector{0, 2, 7, 9}), per_element());
    BOOST_TEST(fronts[2] == (std::vector{1, 5, 8, 11}), per_element());
    BOOST_TEST(fronts[3] == (std::vector{3}), per_element());
}

BOOST_AUTO_TEST_CASE(the_crowding_distances_of_debs_second_front_are_his) {
    // Solutions 1, 3, b, d; the book divides by the ranges 0.9 and 60 of the whole problem and gets 0.63 and
    // 0.12 for 1 and d. A front that spans these ranges is divided by them.
    auto solutions = min_ex();
    const auto distances = crowding_distances(solutions, std::vector{0, 2, 7, 9});
    BOOST_TEST(distances[0] == 0.52 / 0.57 + (1.87 / 0.27 - 3.14 / 0.79) / (1.56 / 0.22 - 3.14 / 0.79),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(distances[1] == infinity);
    BOOST_TEST(distances[2] == infinity);

    const auto in_book_ranges = [](double gap1, double gap2) { return gap1 / 0.9 + gap2 / 60; };
    solutions.push_back({-0.1, -60});
    solutions.push_back({-1, 0});
    const auto book = crowding_distances(solutions, std::vector{12, 2, 9, 0, 7, 13});
    BOOST_TEST(std::abs(book[2] - 0.12) < 0.005);
    BOOST_TEST(std::abs(book[3] - 0.63) < 0.005);
    BOOST_TEST(std::abs(book[3] - in_book_ranges(0.79 - 0.27, 6.93 - 3.97)) < 0.001);
}

BOOST_AUTO_TEST_CASE(every_front_is_the_solutions_that_no_remaining_one_dominates) {
    for (const std::size_t objectives : {1u, 2u, 3u})
        for (std::uint32_t n = 0; n < 30; ++n) {
            // A coarse lattice, so that there are equals; some are not feasible.
            Stream stream = specimens::stream(n);
            std::vector<Objectives> solutions(40);
            for (Objectives &solution : solutions)
                for (std::size_t i = 0; i < objectives && !stream.chance(0.05); ++i)
                    solution.push_back(stream.below(6));
            for (Objectives &solution : solutions)
                if (solution.size() < objectives) solution.clear();
            std::vector<bool> gone(solutions.size());
            std::size_t placed = 0;
            for (const auto &front : non_dominated_fronts(solutions)) {
                std::vector<int> expected;
                for (int a = 0; a < 40; ++a) {
                    bool leads = !gone[a];
                    for (int b = 0; b < 40 && leads; ++b)
                        leads = gone[b] || !dominates(solutions[b], solutions[a]);
                    if (leads) expected.push_back(a);
                }
                BOOST_REQUIRE((front == expected));
                for (const int who : front) gone[who] = true;
                placed += front.size();
            }
            BOOST_REQUIRE(placed == solutions.size());
        }
}

BOOST_AUTO_TEST_CASE(crowding_at_its_limits) {
    const std::vector<Objectives> solutions{{1, 5}, {1, 5}, {1, 5}, {2, 4}, {3, 3}};
    BOOST_TEST(crowding_distances(solutions, {}).empty());
    BOOST_TEST(crowding_distances(solutions, std::vector{3}) == (std::vector{infinity}), per_element());
    BOOST_TEST(crowding_distances(solutions, std::vector{3, 4}) == (std::vector{infinity, infinity}),
               per_element());
    // All equal: the ends of the list, and nothing between.
    BOOST_TEST(crowding_distances(solutions, std::vector{0, 1, 2}) == (std::vector{infinity, 0.0, infinity}),
               per_element());
    // Evenly spaced: half of each range on either side.
    BOOST_TEST(crowding_distances(solutions, std::vector{0, 3, 4}) == (std::vector{infinity, 2.0, infinity}),
               per_element());
    BOOST_TEST(non_dominated_fronts({}).empty());
}
