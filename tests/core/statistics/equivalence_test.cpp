// SPDX-License-Identifier: MIT
// Known answers are those of R 4.2.2:
//   equivalence <- function(x, y, bound) {
//     px <- sapply(x, function(v) mean((v > y) + (v == y) / 2)); py <- sapply(y, function(v) mean((v > x) + (v == x) / 2))
//     m <- length(x); n <- length(y); even <- sqrt((m + n + 1) / (12 * m * n))
//     s <- max(even, sqrt(var(px) / m + var(py) / n)); A <- mean(px)
//     c(A, s, pnorm(-(bound - abs(A - 0.5)) / s), pnorm(-bound / even)) }
#include "statistics/equivalence.h"

#include "base/error.h"
#include "core/statistics/reference.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

void check(const Equivalence &found, double effect, double deviation, double p, double least) {
    BOOST_TEST(found.effect == effect, tt::tolerance(1e-12));
    BOOST_TEST(found.deviation == deviation, tt::tolerance(1e-12));
    BOOST_TEST(found.p == p, tt::tolerance(1e-10));
    BOOST_TEST(found.least == least, tt::tolerance(1e-10));
}

const std::vector<double> x{12.1, 14.5, 9.8,  11.3, 15.2, 13.7, 10.4, 12.9, 16.1, 8.7,
                            14.0, 12.2, 11.8, 13.1, 9.9,  15.8, 12.5, 10.9, 13.4, 11.1},
    y{10.1, 13.5, 9.1,  11.9, 12.2, 13.9, 8.4,  11.9, 13.1, 8.6,
      11.0, 12.9, 10.8, 12.1, 9.3,  13.8, 12.6, 9.9,  11.4, 10.1};

} // namespace

BOOST_AUTO_TEST_CASE(two_one_sided_tests_are_those_of_r) {
    check(equivalence(x, y, 0.21), 0.65125, 0.092421137553411803, 0.26249345509518074, 0.011536990872895338);
    const std::vector<double> tied{1, 2, 2, 3, 5, 5, 5, 8}, others{2, 4, 5, 6, 7, 9, 9};
    check(equivalence(tied, others, 0.3), 0.25892857142857145, 0.15430334996209191, 0.35126747671412595,
          0.025934330325969198);
    // Here DeLong's estimate is the larger: x <- 1:12 / 100 + 5; y <- c(1, 2, 9, 10, 11)
    std::vector<double> narrow;
    for (int i = 1; i <= 12; ++i) narrow.push_back(i / 100.0 + 5);
    check(equivalence(narrow, std::vector<double>{1, 2, 9, 10, 11}, 0.4), 0.4, 0.24494897427831783,
          0.11033568095992334, 0.0057060181930008256);
}

BOOST_AUTO_TEST_CASE(few_values_never_show_that_nothing_differs) {
    // Ten against ten cannot, eleven against eleven can: 0.21 = 1.645 sqrt((2 n + 1) / (12 n^2)) near n = 10.7.
    const auto least = [](std::size_t n) {
        const std::vector<double> equal(n, 7);
        const Equivalence found = equivalence(equal, equal, 0.21);
        BOOST_TEST(found.p == found.least);
        return found.p;
    };
    BOOST_TEST(least(1) > 0.3);
    BOOST_TEST(least(10) > 0.05);
    BOOST_TEST(least(11) < 0.05);
    BOOST_TEST(least(20) < 0.02);
}

BOOST_AUTO_TEST_CASE(the_test_is_symmetric) {
    const Equivalence one = equivalence(x, y, 0.21), other = equivalence(y, x, 0.21);
    BOOST_TEST(one.p == other.p, tt::tolerance(1e-12));
    BOOST_TEST(one.effect + other.effect == 1, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(an_invalid_bound_or_sample_is_an_input_error) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bound : {0.0, 0.5, -0.1, nan}) BOOST_CHECK_THROW(equivalence(x, y, bound), InputError);
    BOOST_CHECK_THROW(equivalence(x, std::vector<double>{}, 0.2), InputError);
}

BOOST_AUTO_TEST_CASE(equivalence_of_pairs_is_that_of_r) {
    for (const Reference &r : references_of("paired_equivalence"))
        BOOST_TEST(paired_equivalence(r.a, r.b, r.expected[0]) == r.expected[1], tt::tolerance(1e-11));
    BOOST_CHECK_THROW(paired_equivalence(x, y, 0), InputError);
    BOOST_CHECK_THROW(paired_equivalence(x, std::vector<double>{1}, 1), InputError);
}
