// SPDX-License-Identifier: MIT
#include "program/arguments.h"

#include "base/error.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

constexpr Option options[] = {
    {"seeds", "A:B", "which seeds"}, {"set", "NAME=VALUE", "a parameter", true}, {"csv", "", "as a table"}};
const Command command{"test",        "FILE",  "a summary",
                      "the details", options, [](const Arguments &, Console &) { return 0; }};

Arguments parsed(const std::vector<std::string> &words) { return parse_arguments(command, words); }

std::string refused(const std::vector<std::string> &words) {
    try {
        parsed(words);
    } catch (const UsageError &error) {
        BOOST_TEST(error.code == 2);
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(options_are_read_in_both_spellings_and_any_order) {
    const Arguments arguments = parsed({"--seeds", "1:3", "file", "--set=a=1", "--csv", "--set", "b=2"});
    BOOST_TEST(arguments.operands == std::vector<std::string>{"file"});
    BOOST_TEST(arguments.text("seeds") == "1:3");
    BOOST_TEST(arguments.has("csv"));
    BOOST_TEST((arguments.all("set") == std::vector<std::string>{"a=1", "b=2"}));
    BOOST_TEST(arguments.text("out", "there") == "there");
}

BOOST_AUTO_TEST_CASE(two_dashes_end_the_options) {
    BOOST_TEST(parsed({"--", "--seeds"}).operands == std::vector<std::string>{"--seeds"});
    BOOST_TEST(parsed({"-"}).operands == std::vector<std::string>{"-"});
}

BOOST_AUTO_TEST_CASE(errors_of_a_command_line_name_the_nearest_option) {
    BOOST_TEST(test::contains(refused({"f", "--sees", "1"}), "has no option --sees; did you mean --seeds?"));
    BOOST_TEST(test::contains(refused({"f", "--nothing-like-it"}), "has no option --nothing-like-it\n"));
    BOOST_TEST(test::contains(refused({"f", "--seeds"}), "--seeds needs a value: --seeds A:B"));
    BOOST_TEST(test::contains(refused({"f", "--csv=1"}), "--csv takes no value"));
    BOOST_TEST(test::contains(refused({"f", "--seeds", "1", "--seeds", "2"}), "--seeds is given twice"));
    BOOST_TEST(test::contains(refused({}), "planula test needs FILE"));
    BOOST_TEST(test::contains(refused({"f", "g"}), "planula test takes one FILE; what is 'g'?"));
    BOOST_TEST(test::contains(refused({"f", "-s", "1"}), "has no option --s"));
}

BOOST_AUTO_TEST_CASE(a_command_may_take_several_operands_but_needs_one) {
    Command several = command;
    several.operand = "FROM...";
    const std::vector<std::string> words{"a", "--csv", "b"};
    BOOST_TEST((parse_arguments(several, words).operands == std::vector<std::string>{"a", "b"}));
    BOOST_CHECK_THROW(parse_arguments(several, std::vector<std::string>{"--csv"}), UsageError);
    BOOST_TEST(test::contains(help_of(several), "usage: planula test FROM... [OPTION]...\n"));
}

BOOST_AUTO_TEST_CASE(whole_numbers_are_whole_and_in_range) {
    BOOST_TEST(parsed({"f", "--seeds", "4"}).whole("seeds", 1, 9) == 4);
    BOOST_TEST(parsed({"f"}).whole("seeds", 1, 9) == 9);
    for (const char *value : {"0", "-1", "1.5", "x", "", "99999999999", "1 "})
        BOOST_CHECK_THROW(parsed({"f", "--seeds", value}).whole("seeds", 1, 9), UsageError);
}

BOOST_AUTO_TEST_CASE(help_shows_every_option) {
    const std::string help = help_of(command);
    BOOST_TEST(test::contains(help, "usage: planula test FILE [OPTION]...\n"));
    BOOST_TEST(test::contains(help, "\n  --set NAME=VALUE  a parameter\n"));
    for (const char *part : {"A summary.", "the details", "which seeds", "a parameter", "as a table"})
        BOOST_TEST(test::contains(help, part), part);
}

BOOST_AUTO_TEST_CASE(long_texts_are_broken_between_words_and_keep_their_paragraphs) {
    std::string text, word = "w…";
    for (int i = 0; i < 100; ++i) text += (i == 0 ? "" : " ") + word;
    text += "\n\nnext";
    const std::string lines = wrapped(text, 4);
    for (std::size_t at = 0, end = 0; at < lines.size(); at = end + 1) {
        end = std::min(lines.find('\n', at), lines.size());
        BOOST_TEST(columns_of(lines.substr(at, end - at)) <= 80);
    }
    BOOST_TEST(test::contains(lines, "w… w…\n    w… w…"));
    BOOST_TEST(lines.ends_with("w…\n\n    next"));
    BOOST_TEST(wrapped("") == "");
    BOOST_TEST(wrapped(std::string(99, 'x')) == std::string(99, 'x'));
}
