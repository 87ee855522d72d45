// SPDX-License-Identifier: MIT
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(the_page_is_what_the_program_prints) {
    const std::string page = test::content(std::filesystem::path(PLANULA_SOURCE_DIR) / "REFERENCE.md");
    const test::Said said = test::planula_says({"reference"});
    BOOST_TEST(said.code == 0);
    BOOST_TEST((said.out == page), "REFERENCE.md is not up to date: run make reference");
}
