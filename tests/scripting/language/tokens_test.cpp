// SPDX-License-Identifier: MIT
#include "language/tokens.h"

#include "base/error.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::string words(std::string_view source) {
    std::string all;
    for (const Token &token : scan(source)) all += std::string(token.word) + "|";
    return all;
}

std::string refused(std::string_view source) {
    return test::refusal([&] { refuse_machine_dependent(scan(source), "a.lua"); });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_source_is_split_into_words_without_comments) {
    BOOST_TEST(words("local x = 1.5e-3 -- end\n--[[ { ]] y=x..\"a--b\"") ==
               "local|x|=|1.5e-3|y|=|x|.|.|a--b|");
    BOOST_TEST(words("a==b ~= [==[ ] ]] ]==] #c") == "a|==|b|~=|[==[ ] ]] ]==]|#|c|");
    BOOST_TEST(words("'it\\'s' 0x1p-4 a.b") == "it\\'s|0x1p-4|a|.|b|");
    BOOST_TEST(words("") == "");
}

BOOST_AUTO_TEST_CASE(lines_are_counted_through_strings_and_comments) {
    const auto tokens = scan("--[[\n\n]] a\n[[\n\n]] b '\\\n' c");
    BOOST_REQUIRE_EQUAL(tokens.size(), 5u);
    BOOST_TEST(tokens[0].line == 3);
    BOOST_TEST(tokens[1].line == 4);
    BOOST_TEST(tokens[2].line == 6);
    BOOST_TEST(tokens[4].line == 7);
}

BOOST_AUTO_TEST_CASE(an_unclosed_text_or_comment_ends_with_the_source) {
    for (const char *source : {"'abc", "\"abc\\", "[[abc", "--[[abc", "[==[", "'", "\\", "{", "0x"})
        BOOST_CHECK_NO_THROW(scan(source));
}

BOOST_AUTO_TEST_CASE(a_power_is_refused_with_its_line_and_what_to_write) {
    BOOST_TEST(refused("local x = 2\nlocal y = x^0.5") ==
               "a.lua:2: '^' gives different results on different machines; write x*x or math.pow(x, y)");
    BOOST_TEST(refused("local y = '^' -- x^2\n") == "");
}

BOOST_AUTO_TEST_CASE(numbers_of_the_foreign_function_interface_are_refused) {
    for (const char *source : {"x = 1LL", "x = 0xffULL", "x = 12i", "x = 1ull"})
        BOOST_TEST(test::contains(refused(source), "a.lua:1: "), source);
    for (const char *source : {"x = 1", "x = 0xff", "x = 1e5", "LL = i"})
        BOOST_TEST(refused(source) == "", source);
}

BOOST_AUTO_TEST_CASE(the_line_of_a_key_is_found_through_nested_tables) {
    const auto tokens = scan("local a = { drag = 0 }\n" // 1
                             "return f {\n"             // 2
                             "  name = 'drag = 1',\n"   // 3
                             "  f = function(x)\n"      // 4
                             "    local a, drag = 1, 2\n"
                             "    if x then return { drag = 1 } end\n"
                             "  end,\n"           // 7
                             "  world = w {\n"    // 8
                             "    drag = 5,\n"    // 9
                             "    ['flow'] = {\n" // 10
                             "      { 1, 2 },\n"  // 11
                             "      { x = 3 },\n" // 12
                             "    },\n"
                             "  },\n"
                             "}\n");
    const std::vector<Step> drag{{"world", 0}, {"drag", 0}},
        second{{"world", 0}, {"flow", 0}, {"", 2}, {"x", 0}};
    BOOST_TEST(line_of_entry(tokens, 2, drag) == 9);
    BOOST_TEST(line_of_entry(tokens, 2, second) == 12);
    BOOST_TEST(line_of_entry(tokens, 2, std::vector<Step>{{"world", 0}}) == 8);
    BOOST_TEST(line_of_entry(tokens, 2, std::vector<Step>{{"world", 0}, {"gravity", 0}}) == 8);
    BOOST_TEST(line_of_entry(tokens, 2, std::vector<Step>{{"flow", 0}}) == 10);
    BOOST_TEST(line_of_entry(tokens, 2, {}) == 2);
    BOOST_TEST(line_of_entry(tokens, 99, drag) == 99);
}

BOOST_AUTO_TEST_CASE(a_requirement_names_its_module_or_is_computed) {
    const auto tokens =
        scan("local a = require 'a'\nlocal b = require(\"b.c\")\n"
             "local function f(x) if x then return require 'd' end return require(x) end\n"
             "require('e' .. a) x.require 'f' require [[g]] require 'h\\n' pcall(require, 'i')");
    std::string all;
    for (const Requirement &found : requirements_of(tokens))
        all += found.module + ":" + std::to_string(found.line) + (found.in_function ? "f " : " ");
    BOOST_TEST(all == "a:1 b.c:2 d:3f :3f :4 :4 :4 :4 ");
}

BOOST_AUTO_TEST_CASE(a_function_is_its_parameters_and_its_body) {
    const auto tokens = scan("local function f(a) -- f\n  return { a, 1, }\nend\nx.y = function() end");
    const auto body = [&](int line) {
        std::string all;
        for (const Token &token : body_of_function(tokens, function_before(tokens, line)))
            all += std::string(token.word) + " ";
        return all;
    };
    BOOST_TEST(body(1) == "( a ) return { a , 1 } ");
    BOOST_TEST(body(3) == body(1));
    BOOST_TEST(body(4) == "( ) ");
    BOOST_TEST(function_before(scan("x = 1"), 1) == 3u);
}

BOOST_AUTO_TEST_CASE(the_last_return_outside_all_blocks_is_found) {
    BOOST_TEST(line_of_return(scan(
                   "local function f()\n return 1\nend\nreturn {\n f = function() return 2 end }")) == 4);
    BOOST_TEST(line_of_return(scan("for i = 1, 2 do\n if x then return end\nend\n")) == 1);
}
