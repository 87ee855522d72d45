// SPDX-License-Identifier: MIT
#include "experiment/revision.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <string>

using namespace planula;

BOOST_AUTO_TEST_CASE(the_revision_is_the_golden_signature) {
    const std::filesystem::path sources = PLANULA_SOURCE_DIR;
    std::ifstream file(sources / "tests/golden/signature");
    std::string golden, more;
    BOOST_REQUIRE(file >> golden);
    BOOST_TEST(!(file >> more));
    BOOST_TEST(golden.size() == 64u);
    BOOST_TEST(model_revision() == golden);
}
