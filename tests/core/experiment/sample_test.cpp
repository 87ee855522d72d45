// SPDX-License-Identifier: MIT
#include "experiment/sample.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 4;

/// Whether the sample of a run of this length has the individual.
bool is_taken(int population, int generations, int generation, int slot) {
    return lot(seed, generation, slot) <
           sample_share(recorded_share, recorded_least, population, generations);
}

} // namespace

BOOST_AUTO_TEST_CASE(the_sample_of_a_short_run_is_all_individuals_and_of_a_long_one_the_least_share) {
    BOOST_TEST(sample_share(0.01, 1000, 10, 100) == 1);
    BOOST_TEST(sample_share(0.01, 1000, 10, 99) == 1);
    BOOST_TEST(sample_share(0.01, 1000, 10, 200) == 0.5);
    BOOST_TEST(sample_share(0.01, 1000, 50, 2000) == 0.01);
    BOOST_TEST(sample_share(0.01, 1000, 300, 2000) == 0.01);
    BOOST_TEST(sample_share(0.01, 0, 10, 1) == 0.01);
    BOOST_TEST(sample_share(0.01, 1000, 2'000'000, 2'000) == 0.01);
    BOOST_TEST(sample_share(2, 0, 10, 10) == 1);
}

BOOST_AUTO_TEST_CASE(all_in_the_sample_of_a_longer_run_were_recorded) {
    for (const int population : {5, 60, 300})
        for (const int generations : {1, 2, 30, 100})
            for (int generation = 0; generation < generations; ++generation)
                for (int slot = 0; slot < population; ++slot)
                    BOOST_TEST_REQUIRE((!is_taken(population, generations, generation, slot) ||
                                        is_in_sample(sample_record, seed, population, generation, slot)));
}

BOOST_AUTO_TEST_CASE(all_individuals_are_recorded_up_to_a_thousand_and_a_share_after) {
    constexpr int population = 50;
    int early = 0, late = 0;
    for (int generation = 0; generation < 20; ++generation)
        for (int slot = 0; slot < population; ++slot)
            early += is_in_sample(sample_record, seed, population, generation, slot);
    BOOST_TEST(early == 1000);
    // From generation 2000 on it is one in a hundred: 500 of 50,000, with a standard deviation of 22.
    for (int generation = 2000; generation < 3000; ++generation)
        for (int slot = 0; slot < population; ++slot)
            late += is_in_sample(sample_record, seed, population, generation, slot);
    BOOST_TEST(late > 400);
    BOOST_TEST(late < 600);
}

BOOST_AUTO_TEST_CASE(a_smaller_sample_is_part_of_a_larger_one) {
    const Recording smaller{.full = false, .least = 300};
    int count = 0;
    for (int generation = 0; generation < 30; ++generation)
        for (int slot = 0; slot < 300; ++slot) {
            const bool is_in = lot(seed, generation, slot) < smaller.share(300, 30);
            count += is_in;
            BOOST_TEST_REQUIRE((!is_in || is_in_sample(smaller, seed, 300, generation, slot)));
            BOOST_TEST_REQUIRE((!is_in_sample(smaller, seed, 300, generation, slot) ||
                                is_in_sample(sample_record, seed, 300, generation, slot)));
        }
    // 300 on average, with a standard deviation of 17.
    BOOST_TEST(count > 230);
    BOOST_TEST(count < 370);
}

BOOST_AUTO_TEST_CASE(a_record_has_one_name) {
    for (const Recording record : {full_record, sample_record, Recording{.full = false, .least = 1},
                                   Recording{.full = false, .least = recorded_most}})
        BOOST_TEST((record_of(name_of(record)) == record), name_of(record));
    BOOST_TEST(name_of(full_record) == "full");
    BOOST_TEST(name_of(sample_record) == "sample");
    BOOST_TEST(name_of({.full = false, .least = 300}) == "sample of 300");
    for (const char *name :
         {"", "Full", "sampel", "sample of ", "sample of 0", "sample of -1", "sample of 0300",
          "sample of 1000", "sample of 1000000001", "sample of 3e2", "sample of 300 "})
        BOOST_TEST(!record_of(name), name);
}

BOOST_AUTO_TEST_CASE(lots_differ_between_seeds_generations_and_slots) {
    BOOST_TEST(lot(1, 2, 3) == lot(1, 2, 3));
    BOOST_TEST(lot(2, 2, 3) != lot(1, 2, 3));
    BOOST_TEST(lot(1, 3, 3) != lot(1, 2, 3));
    BOOST_TEST(lot(1, 2, 4) != lot(1, 2, 3));
    double sum = 0;
    for (int slot = 0; slot < 10'000; ++slot) {
        const double drawn = lot(seed, 0, slot);
        BOOST_TEST_REQUIRE((drawn >= 0 && drawn < 1));
        sum += drawn;
    }
    BOOST_TEST(std::abs(sum / 10'000 - 0.5) < 0.02);
}
