// SPDX-License-Identifier: MIT
// Known answers are those of R 4.2.2 with coin 1.4:
//   pvalue(oneway_test(c(x, y) ~ factor(rep(c("a", "b"), c(length(x), length(y)))), distribution = "exact"))
#include "statistics/permutation.h"

#include "base/error.h"
#include "core/statistics/reference.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

const Shuffling usual{10000, 1, 0};
const std::vector<double> x{12.1, 14.5, 9.8,  11.3, 15.2, 13.7, 10.4, 12.9, 16.1, 8.7,
                            14.0, 12.2, 11.8, 13.1, 9.9,  15.8, 12.5, 10.9, 13.4, 11.1},
    y{10.1, 13.5, 9.1,  11.9, 12.2, 13.9, 8.4,  11.9, 13.1, 8.6,
      11.0, 12.9, 10.8, 12.1, 9.3,  13.8, 12.6, 9.9,  11.4, 10.1};

} // namespace

BOOST_AUTO_TEST_CASE(few_values_are_divided_in_every_way) {
    const std::vector<double> a{1.5, 2.5, 9}, b{3, 4, 4.5, 8};
    const Permutation found = permutation_test(a, b, usual);
    BOOST_TEST(found.exact);
    BOOST_TEST(found.p == 0.8, tt::tolerance(1e-12));
    BOOST_TEST(found.least == 1.0 / 35, tt::tolerance(1e-12));
    BOOST_TEST(found.difference == 13.0 / 3 - 19.5 / 4, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(many_values_are_drawn_and_come_near_the_exact_answer) {
    // Exact: 0.0666478; the standard deviation of 10 000 draws is 0.0025.
    const Permutation found = permutation_test(x, y, usual);
    BOOST_TEST(!found.exact);
    BOOST_TEST(std::abs(found.p - 0.066647845402016709) < 0.0075);
    BOOST_TEST(found.least == 1.0 / 10001);
    BOOST_TEST(found.difference == 1.14, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(draws_repeat_by_seed_and_key) {
    const auto p = [](std::uint64_t seed, std::uint32_t key) {
        return permutation_test(x, y, {10000, seed, key}).p;
    };
    BOOST_TEST(p(1, 0) == p(1, 0));
    BOOST_TEST(p(1, 0) != p(2, 0));
    BOOST_TEST(p(1, 0) != p(1, 1));
}

BOOST_AUTO_TEST_CASE(the_smallest_samples_cannot_be_significant) {
    for (const auto &[a, b] :
         {std::pair<std::vector<double>, std::vector<double>>{{1}, {2}}, {{7, 7}, {7, 7}}}) {
        const Permutation found = permutation_test(a, b, usual);
        BOOST_TEST(found.p == 1);
        BOOST_TEST(found.least == 1);
    }
    const Permutation three =
        permutation_test(std::vector<double>{0.1, 0.2, 0.3}, std::vector<double>{1.1, 1.2, 1.3}, usual);
    BOOST_TEST(three.p == 0.1, tt::tolerance(1e-12)); // 2 of choose(6, 3), whatever the order of the sums
    BOOST_TEST(three.least == 0.1, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_far_difference_has_the_smallest_p) {
    std::vector<double> far = x;
    for (double &value : far) value += 100;
    const Permutation found = permutation_test(far, y, usual);
    BOOST_TEST(found.p == found.least);
}

BOOST_AUTO_TEST_CASE(an_invalid_sample_or_request_is_an_input_error) {
    BOOST_CHECK_THROW(permutation_test(x, std::vector<double>{}, usual), InputError);
    BOOST_CHECK_THROW(permutation_test(x, y, {0, 1, 0}), InputError);
}

BOOST_AUTO_TEST_CASE(signs_of_pairs_are_counted_as_in_r_or_drawn) {
    for (const Reference &r : references_of("paired_permutation")) {
        const Permutation found = paired_permutation_test(r.a, r.b, usual);
        BOOST_TEST(found.exact == (r.kind == "exact"));
        BOOST_TEST(found.difference == r.expected[0], tt::tolerance(1e-12));
        // The standard deviation of a drawn p is at most 0.005.
        if (found.exact)
            BOOST_TEST(found.p == r.expected[1], tt::tolerance(1e-12));
        else
            BOOST_TEST(std::abs(found.p - r.expected[1]) < 0.015);
    }
}

BOOST_AUTO_TEST_CASE(few_pairs_cannot_be_significant_and_draws_repeat) {
    const Permutation three = paired_permutation_test(std::vector<double>{1.1, 1.2, 1.3},
                                                      std::vector<double>{0.1, 0.3, 0.2}, usual);
    BOOST_TEST(three.p == 0.25);
    BOOST_TEST(three.least == 0.25);
    const auto p = [](std::uint32_t key) { return paired_permutation_test(x, y, {10000, 1, key}).p; };
    BOOST_TEST(p(0) == p(0));
    BOOST_TEST(p(0) != p(1));
    BOOST_CHECK_THROW(paired_permutation_test(x, std::vector<double>{1}, usual), InputError);
}
