// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(texts_are_quoted_and_control_characters_escaped) {
    BOOST_TEST(json_text("") == "\"\"");
    BOOST_TEST(json_text("a \"b\" \\ c") == R"("a \"b\" \\ c")");
    BOOST_TEST(json_text("line\nbreak\x01") == R"("line\u000abreak\u0001")");
    BOOST_TEST(json_text("t.u.² é") == "\"t.u.² é\"");
}
