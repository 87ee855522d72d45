// SPDX-License-Identifier: MIT
// The searches beside a slow and obvious writing of the same rules, on ten thousand random cases each.
#include "core/evolution/obvious.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

constexpr std::uint32_t cases = 10'000;

template <class Compare> void compare_all(Compare compare) {
    for (std::uint32_t number = 0; number < cases; ++number) {
        const std::string wrong = compare(number);
        BOOST_TEST_CONTEXT("case " << number) BOOST_REQUIRE_EQUAL(wrong, "");
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(distances_and_clones_agree_with_the_obvious) { compare_all(obvious::compare_distance); }
BOOST_AUTO_TEST_CASE(species_agree_with_the_obvious) { compare_all(obvious::compare_species); }
BOOST_AUTO_TEST_CASE(novelty_and_its_archive_agree_with_the_obvious) {
    compare_all(obvious::compare_novelty);
}

BOOST_AUTO_TEST_CASE(genes_of_children_agree_with_the_obvious_and_coins_are_fair) {
    obvious::Coins coins;
    compare_all([&](std::uint32_t number) { return obvious::compare_crossing(number, coins); });
    // Five standard deviations of fair coins.
    BOOST_TEST(coins.all > 100);
    BOOST_TEST(std::abs(coins.of_mother - coins.all / 2.0) < 2.5 * std::sqrt(coins.all));
    BOOST_TEST(coins.genes > 10'000);
    BOOST_TEST(std::abs(coins.gene_of_mother - coins.genes / 2.0) < 2.5 * std::sqrt(coins.genes));
}
