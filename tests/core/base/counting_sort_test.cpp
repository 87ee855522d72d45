// SPDX-License-Identifier: MIT
#include "base/counting_sort.h"

#include "base/random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;

namespace {

template <std::size_t size> std::vector<std::array<int, size>> some(int count, int bound, Stream &random) {
    std::vector<std::array<int, size>> records(static_cast<std::size_t>(count));
    for (auto &record : records)
        for (int &number : record) number = static_cast<int>(random.below(static_cast<std::uint32_t>(bound)));
    return records;
}

template <std::size_t size> void sorts_as_the_standard_does() {
    Stream random(7, 0, 0, Purpose::sampling);
    for (const int bound : {1, 2, 9, 500})
        for (const int count : {0, 1, 2, 30, 1000}) {
            auto records = some<size>(count, bound, random), expected = records;
            std::sort(expected.begin(), expected.end());
            counting_sort(records, bound);
            BOOST_TEST((records == expected), size << " numbers, " << count << " below " << bound);
        }
}

} // namespace

BOOST_AUTO_TEST_CASE(records_are_ascending_by_their_first_numbers_then_the_next) {
    sorts_as_the_standard_does<1>();
    sorts_as_the_standard_does<2>();
    sorts_as_the_standard_does<3>();
}
