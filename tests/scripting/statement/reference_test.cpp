// SPDX-License-Identifier: MIT
#include "statement/reference.h"

#include "evaluation/life.h"
#include "parameters/parameters.h"
#include "statement/keys.h"
#include "support/scripts.h"

#include <algorithm>
#include <sstream>
#include <string>

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(everything_has_a_row) {
    const std::string page = reference();
    for (const KeyTable &table : key_tables())
        for (const Key &key : table.keys)
            BOOST_TEST(test::contains(page, "| `" + std::string(key.name) + "` |"), key.name);
    for (const ParameterRow &row : parameter_rows())
        BOOST_TEST(test::contains(page, "| `" + std::string(row.name) + "` |"), row.name);
    for (const LifeField &field : life_fields())
        BOOST_TEST(test::contains(page, "`life." + std::string(field.name) + "`") == field.is_shown,
                   field.name);
}

BOOST_AUTO_TEST_CASE(the_rows_of_a_table_have_as_many_cells_as_its_head) {
    std::istringstream page(reference());
    std::ptrdiff_t cells = 0;
    for (std::string line; std::getline(page, line);) {
        const auto bars = std::count(line.begin(), line.end(), '|');
        std::ptrdiff_t escaped = 0;
        for (std::size_t at = line.find("\\|"); at != line.npos; at = line.find("\\|", at + 1)) ++escaped;
        if (!line.starts_with('|')) {
            cells = 0;
            continue;
        }
        if (cells == 0) cells = bars;
        BOOST_TEST(bars - escaped == cells, line);
    }
}
