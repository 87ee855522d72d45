// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(texts_are_quoted_and_control_characters_escaped) {
    BOOST_TEST(json_text("") == "\"\"");
    BOOST_TEST(json_text("a \"b\" \\ c") == R"("a \"b\" \\ c")");
    BOOST_TEST(json_text("line\nbreak\x01") == R"("line\u000abreak\u0001")");
    BOOST_TEST(json_text("t.u.² é") == "\"t.u.² é\"");
}

BOOST_AUTO_TEST_CASE(numbers_lists_and_objects_are_those_of_json) {
    BOOST_TEST(json_number(0.1) == "0.1");
    BOOST_TEST(json_number(std::numeric_limits<double>::infinity()) == "null");
    BOOST_TEST(json_list(std::vector<double>{1, 2.5}, json_number) == "[1,2.5]");
    BOOST_TEST(json_list(std::vector<double>{}, json_number) == "[]");
    BOOST_TEST(JsonObject().add("a", "1").add("b", "[]").text() == "{\"a\":1,\"b\":[]}");
    BOOST_TEST(JsonObject().text() == "{}");
}
