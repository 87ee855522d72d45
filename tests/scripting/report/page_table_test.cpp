// SPDX-License-Identifier: MIT
#include "report/page_table.h"

#include "support/folder.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

BOOST_AUTO_TEST_CASE(numbers_have_six_digits_and_texts_stay) {
    BOOST_TEST(short_field("0.123456789") == "0.123457");
    BOOST_TEST(short_field("-57.63132652424977") == "-57.6313");
    BOOST_TEST(short_field("1.0873229360686947e-06") == "1.08732e-06");
    BOOST_TEST(short_field("123456789") == "123456789");
    BOOST_TEST(short_field("died_out") == "died_out");
    BOOST_TEST(short_field("a, \"b\"") == "\"a, \"\"b\"\"\"");
    BOOST_TEST(short_field("") == "");
}

BOOST_AUTO_TEST_CASE(few_generations_are_shown_all_and_of_many_the_last_one_too) {
    for (const int generations : {1, 2, 249, 250, 251, 2000, 2001}) {
        int shown = 0;
        for (int generation = 0; generation < generations + 5; ++generation)
            shown += is_shown(generation, generations, 250);
        BOOST_TEST(shown <= 251);
        BOOST_TEST(shown >= std::min(generations, 126));
        BOOST_TEST(is_shown(generations - 1, generations, 250));
        BOOST_TEST(!is_shown(generations, generations, 250));
    }
}

BOOST_AUTO_TEST_CASE(rows_are_chosen_by_their_fields) {
    const Folder folder;
    folder.write("table.csv", "name,generation,value\n\"a, b\",0,0.12345678\nc,1,2\n");
    const auto is_first = [](const TableFields &row) { return row.whole("generation") == 0; };
    BOOST_TEST(page_table(folder.path / "table.csv", is_first) ==
               "name,generation,value\n\"a, b\",0,0.123457\n");
    BOOST_TEST(page_rows(folder.path / "table.csv", {"value", "absent"}, {"s,1", "7"}, is_first) ==
               "\"s,1\",7,0.123457,\n");
}
