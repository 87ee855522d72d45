// SPDX-License-Identifier: MIT
#include "statistics/entropy.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(entropy_by_hand) {
    // Eq. (8). Shares 1/2, 1/4, 1/4: ½ ln 2 + 2 · ¼ ln 4 = 1.5 ln 2.
    const double ln2 = 0.69314718055994531;
    BOOST_TEST(entropy(std::vector<int>{8, 30, 8, 12}) == 1.5 * ln2, tt::tolerance(1e-15));
    BOOST_TEST(entropy_of_counts(std::vector<std::int64_t>{5, 0, 10, 5}) == 1.5 * ln2, tt::tolerance(1e-15));
    // Eight equal shares: ln 8, in nats and not in bits.
    BOOST_TEST(entropy(std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}) == 3 * ln2, tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(one_size_or_none_has_no_entropy) {
    BOOST_TEST(entropy(std::vector<int>{}) == 0);
    BOOST_TEST(entropy(std::vector<int>{9}) == 0);
    BOOST_TEST(entropy(std::vector<int>(1000, 9)) == 0);
    BOOST_TEST(entropy_of_counts(std::vector<std::int64_t>{0, 0}) == 0);
}

BOOST_AUTO_TEST_CASE(the_order_and_the_sizes_themselves_do_not_matter) {
    const double H = entropy(std::vector<int>{3, 3, 5, 7, 7, 7, 9});
    BOOST_TEST(entropy(std::vector<int>{7, 3, 9, 7, 5, 3, 7}) == H);
    BOOST_TEST(entropy(std::vector<int>{30, 30, 50, 70, 70, 70, 90}) == H);
    BOOST_TEST(entropy_of_counts(std::vector<std::int64_t>{2, 1, 3, 1}) == H);
}

BOOST_AUTO_TEST_CASE(negative_counts_are_an_input_error) {
    BOOST_CHECK_THROW(entropy_of_counts(std::vector<std::int64_t>{3, -1}), InputError);
}
