// SPDX-License-Identifier: MIT
// Known answers are those of R 4.2.2, cor(x, y, method = "spearman").
#include "statistics/rank_correlation.h"

#include "base/error.h"
#include "core/statistics/reference.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

const std::vector<double> x{2.1, 5.5, 3.3, 8.8, 7.2, 1.1, 9.4}, y{1.9, 6.1, 2.2, 7.7, 8.1, 3.0, 9.0};

/// ((1:count) * factor) %% modulus
std::vector<double> residues(int count, int factor, int modulus) {
    std::vector<double> result;
    for (int i = 1; i <= count; ++i) result.push_back(i * factor % modulus);
    return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(pairs_without_ties_correlate_as_in_r) {
    BOOST_TEST(rank_correlation(x, y).value() == 0.85714285714285687, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(ties_share_their_mean_rank_as_in_r) {
    const std::vector<double> a{1, 2, 2, 3, 5, 5, 5, 8}, b{0, 4, 1, 4, 4, 9, 7, 7};
    BOOST_TEST(rank_correlation(a, b).value() == 0.83544303797468333, tt::tolerance(1e-12));
    // cor(((1:20) * 37) %% 11, ((1:20) * 53) %% 7, method = "spearman")
    BOOST_TEST(rank_correlation(residues(20, 37, 11), residues(20, 53, 7)).value() == 0.16679669851597695,
               tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(only_the_order_counts_and_its_reverse_changes_the_sign) {
    std::vector<double> cubes, reversed;
    for (const double value : x) cubes.push_back(value * value * value), reversed.push_back(-value);
    BOOST_TEST(rank_correlation(x, cubes).value() == 1);
    BOOST_TEST(rank_correlation(x, reversed).value() == -1);
    BOOST_TEST(rank_correlation(cubes, y).value() == rank_correlation(x, y).value());
    BOOST_TEST(rank_correlation(y, x).value() == rank_correlation(x, y).value());
}

BOOST_AUTO_TEST_CASE(equal_values_have_no_correlation) {
    BOOST_TEST(!rank_correlation(x, std::vector<double>(x.size(), 4)).has_value());
    BOOST_TEST(!rank_correlation(std::vector<double>{1}, std::vector<double>{2}).has_value());
}

BOOST_AUTO_TEST_CASE(invalid_pairs_of_samples_are_refused) {
    const std::vector<double> none, bad{1, std::numeric_limits<double>::quiet_NaN()}, two{1, 2};
    BOOST_CHECK_THROW(rank_correlation(none, none), InputError);
    BOOST_CHECK_THROW(rank_correlation(two, bad), InputError);
    BOOST_CHECK_THROW(rank_correlation(two, x), InputError);
}

BOOST_AUTO_TEST_CASE(p_of_a_correlation_is_that_of_r) {
    for (const Reference &r : references_of("rank_correlation")) {
        const RankCorrelation found = rank_correlation_test(r.a, r.b).value();
        BOOST_TEST_CONTEXT(r.a.size() << " pairs") {
            BOOST_TEST(found.rho == r.expected[0], tt::tolerance(1e-12));
            BOOST_TEST(found.p == r.expected[1], tt::tolerance(1e-10));
            BOOST_TEST(found.exact == (r.expected[2] == 1));
        }
    }
}

BOOST_AUTO_TEST_CASE(p_of_few_or_of_perfect_pairs) {
    const RankCorrelation two =
        rank_correlation_test(std::vector<double>{1, 2}, std::vector<double>{3, 4}).value();
    BOOST_TEST(two.p == 1);
    std::vector<double> many;
    for (int i = 0; i < 12; ++i) many.push_back(i);
    BOOST_TEST(rank_correlation_test(many, many).value().p == 0);
    BOOST_TEST(!rank_correlation_test(many, std::vector<double>(12, 1)).has_value());
}
