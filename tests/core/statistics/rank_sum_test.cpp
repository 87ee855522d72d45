// SPDX-License-Identifier: MIT
// Known answers are those of R 4.2.2, wilcox.test with the calls quoted; with ties those of coin 1.4,
//   exact <- function(x, y) pvalue(coin::wilcox_test(
//     c(x, y) ~ factor(rep(c("a", "b"), c(length(x), length(y)))), distribution = "exact"))
#include "statistics/rank_sum.h"

#include "base/error.h"
#include "core/statistics/reference.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

const std::vector<double> a{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
const std::vector<double> b{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06001, 3.14, 1.295};

/// from, from + 1, … to
std::vector<double> sequence(int from, int to) {
    std::vector<double> result;
    for (int i = from; i <= to; ++i) result.push_back(i);
    return result;
}

/// ((1:count) * factor) %% modulus + offset
std::vector<double> residues(int count, int factor, int modulus, double offset) {
    std::vector<double> result;
    for (int i = 1; i <= count; ++i) result.push_back(i * factor % modulus + offset);
    return result;
}

void check(const RankSum &test, double statistic, double p, bool exact) {
    BOOST_TEST(test.statistic == statistic);
    BOOST_TEST(test.p == p, tt::tolerance(1e-12));
    BOOST_TEST(test.exact == exact);
}

} // namespace

BOOST_AUTO_TEST_CASE(small_samples_without_ties_are_tested_exactly) {
    check(rank_sum(a, b), 58, 0.13591114767585355, true); // wilcox.test(a, b)
    // wilcox.test(1:20, 21:40)
    check(rank_sum(sequence(1, 20), sequence(21, 40)), 0, 1.4508889103849688e-11, true);
    // x <- ((1:49) * 37) %% 101; y <- ((1:49) * 53) %% 103 + 0.5; wilcox.test(x, y)
    check(rank_sum(residues(49, 37, 101, 0), residues(49, 53, 103, 0.5)), 1286, 0.54751439594303275, true);
    // x <- (1:20)^2 / 7; y <- (1:20)^2 / 7 + 9.5 + (1:20) / 13; wilcox.test(x, y)
    std::vector<double> x, y;
    for (int i = 1; i <= 20; ++i) {
        x.push_back(i * i / 7.0);
        y.push_back(i * i / 7.0 + 9.5 + i / 13.0);
    }
    check(rank_sum(x, y), 130, 0.059563831561703591, true);
}

BOOST_AUTO_TEST_CASE(small_samples_with_ties_are_tested_exactly) {
    // exact(rep(2, n), rep(1, n)), n = 2 … 6: all of one above all of the other
    const double above[]{0.33333333333333331, 0.1, 0.028571428571428571, 0.0079365079365079361,
                         0.0021645021645021645};
    for (std::size_t n = 2; n <= 6; ++n) {
        const RankSum found = rank_sum(std::vector<double>(n, 2), std::vector<double>(n, 1));
        check(found, static_cast<double>(n * n), above[n - 2], true);
        BOOST_TEST(found.least == found.p);
    }
    // exact(c(1,2,2,3,5,5,5,8), c(2,4,5,6,7,9,9))
    const std::vector<double> tied{1, 2, 2, 3, 5, 5, 5, 8}, others{2, 4, 5, 6, 7, 9, 9};
    check(rank_sum(tied, others), 14.5, 0.1209013209013209, true);
    // exact(((1:20) * 37) %% 11, ((1:20) * 53) %% 13)
    check(rank_sum(residues(20, 37, 11, 0), residues(20, 53, 13, 0)), 197.5, 0.95205843894241626, true);
    // exact(((1:20) * 37) %% 5, ((1:20) * 53) %% 7 + 1)
    check(rank_sum(residues(20, 37, 5, 0), residues(20, 53, 7, 1)), 82, 0.0008936908100229665, true);
    // exact(((1:49) * 37) %% 23, ((1:49) * 53) %% 29)
    check(rank_sum(residues(49, 37, 23, 0), residues(49, 53, 29, 0)), 897.5, 0.03091929027467585, true);
    // A distribution that is not symmetric: exact(c(0,0,0,0,1), c(0,1,2,3,3,4,9))
    check(rank_sum(std::vector<double>{0, 0, 0, 0, 1}, std::vector<double>{0, 1, 2, 3, 3, 4, 9}), 3.5,
          0.022727272727272728, true);
}

BOOST_AUTO_TEST_CASE(so_few_values_cannot_give_a_smaller_p) {
    // 2 / choose(2 n, n)
    const double least[]{1, 1.0 / 3, 0.1, 2.0 / 70};
    for (int n = 1; n <= 4; ++n) {
        std::vector<double> odd, even;
        for (int i = 1; i <= n; ++i) odd.push_back(2 * i - 1), even.push_back(2 * i);
        BOOST_TEST(rank_sum(odd, even).least == least[n - 1], tt::tolerance(1e-12));
        BOOST_TEST(rank_sum(odd, even).p >= least[n - 1]);
    }
}

BOOST_AUTO_TEST_CASE(large_samples_take_the_normal_approximation) {
    // x <- ((1:60) * 37) %% 101; y <- ((1:55) * 53) %% 103 + 0.5; wilcox.test(x, y)
    const auto x = residues(60, 37, 101, 0), y = residues(55, 53, 103, 0.5);
    check(rank_sum(x, y), 1751, 0.5736446507799613, false);
    // wilcox.test(1:3, 4:100): one sample of 50 or more is enough
    check(rank_sum(sequence(1, 3), sequence(4, 100)), 0, 0.0033908106810643336, false);
    // wilcox.test(c(1,2,2,3,5,5,5,8), c(2,4,5,6,7,9,9), exact = FALSE, correct = TRUE)
    const std::vector<double> tied{1, 2, 2, 3, 5, 5, 5, 8}, others{2, 4, 5, 6, 7, 9, 9};
    check(rank_sum(tied, others, RankMethod::normal), 14.5, 0.12725393975018059, false);
}

BOOST_AUTO_TEST_CASE(either_method_can_be_forced) {
    // wilcox.test(a, b, exact = FALSE, correct = TRUE)
    check(rank_sum(a, b, RankMethod::normal), 58, 0.13332021558962748, false);
    // wilcox.test(1:20, 21:40, exact = FALSE)
    check(rank_sum(sequence(1, 20), sequence(21, 40), RankMethod::normal), 0, 6.7956151281733675e-08, false);
    // wilcox.test(x, y, exact = TRUE), x and y of 60 and 55 values as above
    check(rank_sum(residues(60, 37, 101, 0), residues(55, 53, 103, 0.5), RankMethod::exact), 1751,
          0.57499832586045585, true);
}

BOOST_AUTO_TEST_CASE(the_smallest_samples_cannot_be_significant) {
    check(rank_sum(std::vector<double>{1}, std::vector<double>{2}), 0, 1, true);    // wilcox.test(1, 2)
    check(rank_sum(std::vector<double>{3, 1}, std::vector<double>{2}), 1, 1, true); // wilcox.test(c(3, 1), 2)
    // wilcox.test(c(1, 2), c(1.5, 1.7), exact = FALSE)
    check(rank_sum(std::vector<double>{1, 2}, std::vector<double>{1.5, 1.7}, RankMethod::normal), 2, 1,
          false);
}

BOOST_AUTO_TEST_CASE(equal_values_have_p_1) {
    check(rank_sum(std::vector<double>(20, 7), std::vector<double>(20, 7)), 200, 1, true);
    check(rank_sum(std::vector<double>{7}, std::vector<double>{7}), 0.5, 1, true);
    const std::vector<double> many(60, 7);
    check(rank_sum(many, many), 1800, 1, false);
}

BOOST_AUTO_TEST_CASE(the_test_is_symmetric_and_depends_on_ranks_alone) {
    for (const auto method : {RankMethod::exact, RankMethod::normal}) {
        const RankSum one = rank_sum(a, b, method), other = rank_sum(b, a, method);
        BOOST_TEST(one.p == other.p);
        BOOST_TEST(one.statistic + other.statistic == 81);
        std::vector<double> cubes_a = a, cubes_b = b;
        for (auto *values : {&cubes_a, &cubes_b})
            for (double &value : *values) value = value * value * value;
        std::reverse(cubes_a.begin(), cubes_a.end());
        BOOST_TEST(rank_sum(cubes_a, cubes_b, method).p == one.p);
    }
}

BOOST_AUTO_TEST_CASE(an_empty_sample_or_nan_is_refused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(rank_sum(std::vector<double>{}, b), InputError);
    BOOST_CHECK_THROW(rank_sum(a, std::vector<double>{}), InputError);
    BOOST_CHECK_THROW(rank_sum(a, std::vector<double>{1, nan}), InputError);
}

BOOST_AUTO_TEST_CASE(normal_approximations_are_those_of_r) {
    for (const Reference &r : references_of("rank_sum")) {
        const RankMethod method = r.kind == "normal"      ? RankMethod::normal
                                  : r.kind == "automatic" ? RankMethod::automatic
                                                          : RankMethod::normal_without_continuity;
        check(rank_sum(r.a, r.b, method), r.expected[0], r.expected[1], false);
    }
}

BOOST_AUTO_TEST_CASE(an_exact_test_of_too_many_values_is_refused) {
    BOOST_CHECK_THROW(rank_sum(sequence(1, 101), sequence(1, 3), RankMethod::exact), InputError);
}
